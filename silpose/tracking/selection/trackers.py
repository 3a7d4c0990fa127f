"""Trackers and dynamics with the settings that are best on held-out takes."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, partial

import numpy as np
from sklearn.base import clone

from silpose.core.pose_space import PoseSpace
from silpose.core.stages import timed
from silpose.core.types import Array, Settings
from silpose.regression import Candidates, Fold, Outcome
from silpose.tracking.belief_tracker import BeliefTracker
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.key_poses import KeyPoses
from silpose.tracking.selection.candidates import settings_to_choose
from silpose.tracking.selection.stacking import choose_shares
from silpose.tracking.selection.tracker_selection import (
    FEW_KEY_POSES,
    Estimate,
    FittedFold,
    TrackerSelection,
    error_outcome,
    outcomes,
)
from silpose.tracking.single_pose_tracker import SinglePoseTracker
from silpose.tracking.state_sensitive import StateSensitiveRegressor, observed_and_sampled

_FEW_KERNELS = 700  # of the paper's tracker while its widths are being chosen,
_FEW_EXAMPLES = 10_000  # from which they learn

Sampled = tuple[Array, Array, Array]
"""Predictions, descriptors and poses, as `observed_and_sampled` returns them."""


@timed("tracking")
def choose_belief_tracker(
    selection: TrackerSelection, candidates: Candidates[BeliefTracker]
) -> BeliefTracker:
    """Fit the tracker whose kernel widths, then whose shares are best without lag.

    Parameters
    ----------
    selection : TrackerSelection
        Accounts for it as method ``tracker``.
    candidates : Candidates of BeliefTracker
        Shares regressed on the silhouette alone that are None are stacked.
    """
    candidates = candidates.with_parameters(
        space=selection.space.name, frames_per_second=selection.frames_per_second
    )
    settings = settings_to_choose(
        "tracker", candidates, "pose_width", "descriptor_width", "damping", also=("restart",)
    )
    fitted = cache(lambda: selection.fitted_folds(partial(few_key_poses, candidates)))
    scorer = partial(_score_beliefs, candidates, selection.space)
    chosen = selection.choose(
        "tracker", settings, scorer, fitted, fitted_once=("pose_width",), prefer="processes"
    )
    tracker = candidates.create(**chosen)
    fit = partial(_fit_to_key_poses, tracker)
    shares = choose_shares(selection, "tracker", tracker, chosen, fit, fitted)
    return tracker.set_params(**shares).fit(selection.train)


def few_key_poses(candidates: Candidates, fold: Fold) -> KeyPoses:
    """Cluster the training poses of a fold, into few key poses while settings are chosen."""
    keep = min(candidates.estimator.keep, FEW_KEY_POSES / len(fold.x))
    keys: KeyPoses = candidates.create(keep=keep).key_poses(fold.train)
    return keys


def _fit_to_key_poses(tracker: BeliefTracker, fold: FittedFold[KeyPoses]) -> BeliefTracker:
    return clone(tracker).use_fitted(fold.fitted)


def _score_beliefs(
    candidates: Candidates[BeliefTracker],
    space: PoseSpace,
    fold: FittedFold[KeyPoses],
    settings: Sequence[Settings],
) -> list[Outcome]:
    tracker = candidates.create(heading_alone=0.0, body_alone=0.0)
    compared = [fold.fitted.examples.compare(z) for z, _ in fold.validation]
    found: list[Outcome] = []
    last: Settings = {}
    for setting in settings:
        changed = {name for name in setting if name not in last or last[name] != setting[name]}
        tracker.set_params(**setting)
        if changed & {"pose_width", "restart"}:
            tracker.use_fitted(fold.fitted)
        if changed - {"damping"}:  # which has no influence on beliefs
            beliefs = [tracker.filtered(own)[0] for own in compared]
        estimated = map(tracker.regress, beliefs, compared)
        found.append(error_outcome(space, fold, estimated))
        last = setting
    return found


@timed("tracking")
def choose_dynamics(
    selection: TrackerSelection, candidates: Candidates[SecondOrderDynamics]
) -> SecondOrderDynamics:
    """Fit the dynamics that best predict a frame from the two before it.

    Parameters
    ----------
    selection : TrackerSelection
        Accounts for it as method ``dynamics``.
    candidates : Candidates of SecondOrderDynamics
    """
    settings = settings_to_choose("dynamics", candidates, "damping")
    scorer = partial(_score_dynamics, candidates, selection.space)
    chosen = selection.choose("dynamics", settings, scorer, lambda: selection.folds)
    return candidates.create(**chosen).fit([x for _, x in selection.train])


def _score_dynamics(
    candidates: Candidates[SecondOrderDynamics],
    space: PoseSpace,
    fold: Fold,
    settings: Sequence[Settings],
) -> list[Outcome]:
    found = []
    for setting in settings:
        model = candidates.create(**setting).fit([x for _, x in fold.train])
        predicted = [
            np.vstack([x[:2], model.predict(x[1:-1], x[:-2])])[: len(x)] for _, x in fold.validation
        ]
        found.append(error_outcome(space, fold, predicted))
    return found


@timed("tracking")
def choose_single_pose_tracker(
    selection: TrackerSelection,
    candidates: Candidates[StateSensitiveRegressor],
    single_pose: Candidates[SinglePoseTracker],
    dynamics: SecondOrderDynamics,
) -> SinglePoseTracker:
    """Fit the paper's tracker, with the kernel widths that are best.

    Parameters
    ----------
    selection : TrackerSelection
        Accounts for it as method ``state_sensitive``.
    candidates : Candidates of StateSensitiveRegressor
    single_pose : Candidates of SinglePoseTracker
        Nothing is chosen of them.
    dynamics : SecondOrderDynamics
        With the settings chosen already.
    """
    settings_to_choose("single_pose", single_pose)
    tracker = single_pose.create(dynamics=dynamics, frames_per_second=selection.frames_per_second)
    settings = settings_to_choose(
        "state_sensitive", candidates, "pose_width", "descriptor_width", also=("damping", "linear")
    )
    chosen = selection.choose(
        "state_sensitive",
        settings,
        partial(_score_single_pose, tracker, candidates, selection.space),
        lambda: selection.fitted_folds(partial(_observed_and_sampled, tracker)),
        fitted_once=list(settings[0]),
    )
    return tracker.set_params(regressor=candidates.create(**chosen)).fit(selection.train)


def _observed_and_sampled(
    tracker: SinglePoseTracker, fold: Fold
) -> tuple[SecondOrderDynamics, Sampled]:
    """Fit dynamics to a fold, and sample training examples around their predictions."""
    dynamics = clone(tracker.dynamics).fit([x for _, x in fold.train])
    examples = observed_and_sampled(fold.train, dynamics, tracker.samples, most=_FEW_EXAMPLES)
    return dynamics, examples


def _score_single_pose(
    tracker: SinglePoseTracker,
    candidates: Candidates[StateSensitiveRegressor],
    space: PoseSpace,
    fold: FittedFold[tuple[SecondOrderDynamics, Sampled]],
    settings: Sequence[Settings],
) -> list[Outcome]:
    few = min(_FEW_KERNELS, candidates.estimator.centres)
    dynamics, examples = fold.fitted

    def estimate(setting: Settings) -> Estimate:
        regressor = candidates.create(**setting, centres=few, keep_at_most=None).fit(*examples)
        fitted = clone(tracker).use_fitted(dynamics, regressor)
        return lambda z, start: fitted.track(z, start).x

    return outcomes(space, fold, map(estimate, settings))
