"""Trackers, and the rivals they are measured against, each with the settings best on validation."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.regression import RidgeRegressor
from silpose.tracking.belief_tracker import BeliefTracker
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.key_poses import KeyPoses
from silpose.tracking.selection.search import (
    FEW_KEY_POSES,
    Estimate,
    Examples,
    Family,
    Maker,
    Selection,
)
from silpose.tracking.selection.settings import (
    DynamicsSettings,
    JointSettings,
    RivalSettings,
    TrackerSettings,
)
from silpose.tracking.selection.stacking import shares_of
from silpose.tracking.single_pose_tracker import SinglePoseTracker
from silpose.tracking.smoothing_baselines import fuse, smooth, viterbi, windowed
from silpose.tracking.state_sensitive import StateSensitiveRegressor, observed_and_sampled

Array = NDArray[np.float64]

_FEW_KERNELS = 700  # of the paper's tracker while its widths are being chosen,
_FEW_EXAMPLES = 10_000  # from which they learn


def choose_tracker(selection: Selection, settings: TrackerSettings) -> BeliefTracker:
    """Fit the tracker whose kernel widths, then whose shares are best when it may not wait."""

    def tracker(
        keep: float = settings.keep,
        heading_alone: float = 0.0,
        body_alone: float = 0.0,
        **chosen: float,
    ) -> BeliefTracker:
        return BeliefTracker(
            selection.space.name,
            keep,
            restart=settings.restart,
            frames_per_second=selection.frames_per_second,
            random_state=settings.random_state,
            heading_alone=heading_alone,
            body_alone=body_alone,
            **chosen,
        )

    def key_poses(learnt: Examples) -> KeyPoses:
        frames = sum(len(x) for _, x in learnt)
        return tracker(min(settings.keep, FEW_KEY_POSES / frames)).key_poses(learnt)

    def family(learnt: Examples) -> Maker:
        keys = key_poses(learnt)
        fitted = cache(lambda pose_width: tracker(pose_width=pose_width).take(keys))
        return lambda pose_width, **rest: (
            lambda z, _: fitted(pose_width).set_params(**rest).track(z).x
        )

    grid = {
        "pose_width": settings.pose_width,
        "descriptor_width": settings.descriptor_width,
        "damping": settings.damping,
    }
    best = selection.best("tracker", grid, family)
    shares = shares_of(
        "tracker", settings, selection, lambda some: tracker(**best).take(key_poses(some))
    )
    return tracker(**best, **shares).fit(selection.train)


def choose_dynamics(selection: Selection, settings: DynamicsSettings) -> SecondOrderDynamics:
    """Fit the dynamics that best predict a frame from the two before it."""
    ahead = replace(  # whose inputs are the poses themselves
        selection,
        train=[(x, x) for _, x in selection.train],
        validation=[(x, x) for _, x in selection.validation],
    )

    def family(learnt: Examples) -> Maker:
        def estimate(damping: float) -> Estimate:
            model = SecondOrderDynamics(damping).fit([x for x, _ in learnt])
            return lambda x, _: np.vstack([x[:2], model.predict(x[1:-1], x[:-2])])[: len(x)]

        return estimate

    best = ahead.best("dynamics", {"damping": settings.damping}, family)
    return SecondOrderDynamics(**best).fit([x for _, x in selection.train])


def choose_joint(
    selection: Selection, settings: JointSettings, dynamics: SecondOrderDynamics
) -> SinglePoseTracker:
    """Fit the paper's tracker, its kernel widths the best."""

    def regressor(centres: int, keep: float | None, **widths: float) -> StateSensitiveRegressor:
        return StateSensitiveRegressor(
            linear=settings.linear,
            damping=settings.damping,
            centres=centres,
            keep_at_most=keep,
            random_state=settings.random_state,
            **widths,
        )

    def family(learnt: Examples) -> Maker:
        ahead = clone(dynamics).fit([x for _, x in learnt])
        examples = observed_and_sampled(learnt, ahead, settings.samples, most=_FEW_EXAMPLES)

        def estimate(**widths: float) -> Estimate:
            few = regressor(min(_FEW_KERNELS, settings.centres), None, **widths).fit(*examples)
            return lambda z, start: SinglePoseTracker(ahead, few).track(z, start)[0]

        return estimate

    grid = {
        "pose_width": settings.pose_width,
        "descriptor_width": settings.descriptor_width,
    }
    best = selection.best("joint", grid, family)
    all_kernels = regressor(settings.centres, settings.keep_at_most, **best)
    return SinglePoseTracker(clone(dynamics), all_kernels, settings.samples).fit(selection.train)


def choose_rivals(
    selection: Selection,
    settings: RivalSettings,
    ridge: RidgeRegressor,
    dynamics: SecondOrderDynamics,
) -> dict[str, Estimate]:
    """Give what else makes single-image answers smooth, by method.

    Parameters
    ----------
    selection : Selection
    settings : RivalSettings
    ridge : RidgeRegressor
        The single-image regressor, whose settings are chosen already.
    dynamics : SecondOrderDynamics
        Likewise.
    """

    def regressor(learnt: Examples, window: int = 1) -> RidgeRegressor:
        z = np.concatenate([windowed(z, window) for z, _ in learnt])
        twin = RidgeRegressor(ridge.basis, ridge.damping)
        twin.fit(z, np.concatenate([x for _, x in learnt]))
        return twin

    def smoothed(learnt: Examples) -> Maker:
        single = regressor(learnt)
        return lambda smoothing: lambda z, _: smooth(single.predict(z), smoothing)

    def fused(learnt: Examples) -> Maker:
        single = regressor(learnt)
        ahead = clone(dynamics).fit([x for _, x in learnt])
        return lambda weight: lambda z, _: fuse(single.predict(z), ahead, weight)

    def wide(learnt: Examples) -> Maker:
        def estimate(window: int) -> Estimate:
            several = regressor(learnt, window)
            return lambda z, _: several.predict(windowed(z, window))

        return estimate

    def path(learnt: Examples) -> Maker:
        z_train, x_train = (np.concatenate(part) for part in zip(*learnt, strict=True))
        return lambda neighbours, weight, smoothing: (
            lambda z, _: smooth(viterbi(z_train, x_train, z, neighbours, weight), smoothing)
        )

    smoothing = {"smoothing": settings.smoothing}
    several = {"neighbours": settings.neighbours, "weight": settings.viterbi_weight}
    rivals: dict[str, tuple[dict, Family]] = {
        "smoothed": (smoothing, smoothed),
        "fused": ({"weight": settings.fusion}, fused),
        "windowed": ({"window": settings.window}, wide),
        "nearest_smoothed": ({"neighbours": 1, "weight": 0.0} | smoothing, path),
        "nearest_viterbi": (several | smoothing, path),
    }
    return {
        method: family(selection.train)(**selection.best(method, grid, family))
        for method, (grid, family) in rivals.items()
    }
