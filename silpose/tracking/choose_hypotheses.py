"""The multiple hypothesis tracker with the settings best on validation."""

from __future__ import annotations

import numpy as np
from sklearn.base import clone

from silpose.regression import MixtureOfRegressors
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.multiple_hypothesis import MultipleHypothesisTracker
from silpose.tracking.selection import FEW_KEY_POSES, Examples, Maker, Selection
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

    def tracker(keep: float = settings.keep, **chosen: float) -> MultipleHypothesisTracker:
        return MultipleHypothesisTracker(
            clone(mixture),
            clone(dynamics),
            selection.space.name,
            settings.count,
            fresh=settings.fresh,
            keep=keep,
            pose_width=settings.pose_width,
            descriptor_width=settings.descriptor_width,
            damping=settings.damping,
            frames_per_second=selection.frames_per_second,
            random_state=settings.random_state,
            **chosen,
        )

    def family(learnt: Examples) -> Maker:
        z, x = (np.concatenate(part) for part in zip(*learnt, strict=True))
        poses = [own for _, own in learnt]
        keys = tracker(keep=min(settings.keep, FEW_KEY_POSES / len(x))).key_poses(learnt)
        fitted = clone(mixture).fit(z, x), clone(dynamics).fit(poses), keys, poses
        return lambda **chosen: lambda z, _: tracker(**chosen).take(*fitted).track(z, modes=1).x

    grid = {"drift": settings.drift, "trust": settings.trust, "past": settings.past}
    best = selection.best("hypotheses", grid, family)
    chosen = tracker(**best)
    keys = chosen.key_poses(selection.train)
    return chosen.take(mixture, dynamics, keys, [x for _, x in selection.train])
