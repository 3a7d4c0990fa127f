"""The multiple hypothesis tracker with the settings best on validation."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.regression import MixtureOfRegressors
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.key_poses import KeyPoses
from silpose.tracking.multiple_hypothesis_tracker import MultipleHypothesisTracker
from silpose.tracking.selection.search import FEW_KEY_POSES, Examples, Maker, Selection
from silpose.tracking.selection.settings import HypothesesSettings
from silpose.tracking.selection.stacking import shares_of

Array = NDArray[np.float64]


def choose_hypotheses(
    selection: Selection,
    settings: HypothesesSettings,
    mixture: MixtureOfRegressors,
    dynamics: SecondOrderDynamics,
) -> MultipleHypothesisTracker:
    """Fit the tracker whose settings, then shares are best causally, with no start given.

    Parameters
    ----------
    selection : Selection
    settings : HypothesesSettings
    mixture, dynamics
        Fitted to all training sequences, with settings that are chosen already.
    """

    def tracker(
        keep: float = settings.keep, body_alone: float = 0.0, **chosen: float
    ) -> MultipleHypothesisTracker:
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
            body_alone=body_alone,
            frames_per_second=selection.frames_per_second,
            random_state=settings.random_state,
            **chosen,
        )

    def fitted(
        learnt: Examples,
    ) -> tuple[MixtureOfRegressors, SecondOrderDynamics, KeyPoses, list[Array]]:
        z, x = (np.concatenate(part) for part in zip(*learnt, strict=True))
        poses = [own for _, own in learnt]
        keys = tracker(min(settings.keep, FEW_KEY_POSES / len(x))).key_poses(learnt)
        return clone(mixture).fit(z, x), clone(dynamics).fit(poses), keys, poses

    def family(learnt: Examples) -> Maker:
        own = fitted(learnt)
        return lambda **chosen: lambda z, _: tracker(**chosen).take(*own).track(z, modes=1).x

    grid = {"drift": settings.drift, "trust": settings.trust, "past": settings.past}
    best = selection.best("hypotheses", grid, family)
    shares = shares_of(
        "hypotheses", settings, selection, lambda some: tracker(**best).take(*fitted(some))
    )
    chosen = tracker(**best, **shares)
    keys = chosen.key_poses(selection.train)
    return chosen.use_fitted(mixture, dynamics, keys, [x for _, x in selection.train])
