"""The multiple hypothesis tracker with the settings best on validation."""

from __future__ import annotations

import numpy as np
from sklearn.base import clone

from silpose.regression import MixtureOfRegressors
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.multiple_hypothesis import MultipleHypothesisTracker
from silpose.tracking.selection import Examples, Maker, Selection
from silpose.tracking.settings import HypothesesSettings


def choose_hypotheses(
    selection: Selection,
    settings: HypothesesSettings,
    mixture: MixtureOfRegressors,
    dynamics: SecondOrderDynamics,
) -> MultipleHypothesisTracker:
    """Fit the tracker whose settings are best when it may not wait, and nobody tells the start.

    Parameters
    ----------
    selection : Selection
    settings : HypothesesSettings
    mixture, dynamics
        Fitted to all training sequences, with settings that are chosen already.
    """

    def tracker(**chosen: float) -> MultipleHypothesisTracker:
        return MultipleHypothesisTracker(
            clone(mixture),
            clone(dynamics),
            settings.count,
            fresh=settings.fresh,
            frames_per_second=selection.frames_per_second,
            random_state=settings.random_state,
            **chosen,
        )

    def family(learnt: Examples) -> Maker:
        z, x = (np.concatenate(part) for part in zip(*learnt, strict=True))
        poses = [own for _, own in learnt]
        fitted = clone(mixture).fit(z, x), clone(dynamics).fit(poses), poses
        return lambda **chosen: lambda z, _: tracker(**chosen).take(*fitted).track(z, modes=1).x

    grid = {"drift": settings.drift, "trust": settings.trust, "past": settings.past}
    best = selection.best("hypotheses", grid, family)
    return tracker(**best).take(mixture, dynamics, [x for _, x in selection.train])
