"""The multiple hypothesis tracker with the settings that are best on held-out takes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, partial

from sklearn.base import clone

from silpose.core.parallel import parallel_map
from silpose.core.pose_space import PoseSpace
from silpose.core.stages import timed
from silpose.core.types import Array, Settings
from silpose.regression import Candidates, ChosenMixture, Fold, MixtureOfRegressors, Outcome
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.key_poses import KeyPoses
from silpose.tracking.multiple_hypothesis_tracker import MultipleHypothesisTracker
from silpose.tracking.selection.candidates import settings_to_choose
from silpose.tracking.selection.stacking import choose_shares
from silpose.tracking.selection.tracker_selection import (
    FittedFold,
    TrackerSelection,
    error_outcome,
)
from silpose.tracking.selection.trackers import few_key_poses

_CHOSEN = ("process_noise", "likelihood_exponent", "velocity_gain")
_MORE = (
    "n_particles", "birth_probability", "surprise", "pose_width", "descriptor_width", "damping",
)  # fmt: skip


@dataclass(frozen=True)
class _Parts:
    """The parts of a tracker that are fitted to a fold, whatever its settings."""

    mixture: MixtureOfRegressors
    dynamics: SecondOrderDynamics
    keys: KeyPoses
    poses: list[Array]

    @classmethod
    def fit(
        cls,
        candidates: Candidates[MultipleHypothesisTracker],
        dynamics: SecondOrderDynamics,
        fold_and_mixture: tuple[Fold, MixtureOfRegressors],
    ) -> _Parts:
        fold, mixture = fold_and_mixture
        poses = [x for _, x in fold.train]
        return cls(mixture, clone(dynamics).fit(poses), few_key_poses(candidates, fold), poses)

    def use(self, tracker: MultipleHypothesisTracker) -> MultipleHypothesisTracker:
        return tracker.use_fitted(self.mixture, self.dynamics, self.keys, self.poses)


@timed("tracking")
def choose_hypothesis_tracker(
    selection: TrackerSelection,
    candidates: Candidates[MultipleHypothesisTracker],
    mixture: ChosenMixture,
    dynamics: SecondOrderDynamics,
) -> MultipleHypothesisTracker:
    """Fit the tracker whose settings, then whose shares are best without lag and known poses.

    Parameters
    ----------
    selection : TrackerSelection
        Accounts for it as method ``hypotheses``.
    candidates : Candidates of MultipleHypothesisTracker
        Shares regressed on the silhouette alone that are None are stacked.
    mixture : ChosenMixture
        Chosen on the same takes; fitted to all of them, and to each fold.
    dynamics : SecondOrderDynamics
        Fitted to all training takes, with the settings chosen already.
    """
    candidates = candidates.with_parameters(
        mixture=clone(mixture.mixture),
        dynamics=clone(dynamics),
        space=selection.space.name,
        frames_per_second=selection.frames_per_second,
    )
    settings = settings_to_choose("hypotheses", candidates, *_CHOSEN, also=_MORE)

    @cache
    def fitted() -> list[FittedFold[_Parts]]:
        folds = selection.folds
        pairs = zip(folds, (own for _, own in mixture.by_fold), strict=True)
        parts = parallel_map(
            partial(_Parts.fit, candidates, dynamics), list(pairs), prefer="threads"
        )
        return [
            FittedFold(fold.train, fold.validation, own)
            for fold, own in zip(folds, parts, strict=True)
        ]

    chosen = selection.choose(
        "hypotheses",
        settings,
        partial(_score, candidates, selection.space),
        fitted,
        fitted_once=list(settings[0]),
        prefer="processes",
    )
    tracker = candidates.create(**chosen)
    fit = partial(_fit, tracker)
    shares = choose_shares(selection, "hypotheses", tracker, chosen, fit, fitted)
    tracker.set_params(**shares)
    poses = [x for _, x in selection.train]
    return tracker.use_fitted(mixture.mixture, dynamics, tracker.key_poses(selection.train), poses)


def _fit(tracker: MultipleHypothesisTracker, fold: FittedFold[_Parts]) -> MultipleHypothesisTracker:
    return fold.fitted.use(clone(tracker))


def _score(
    candidates: Candidates[MultipleHypothesisTracker],
    space: PoseSpace,
    fold: FittedFold[_Parts],
    settings: Sequence[Settings],
) -> list[Outcome]:
    found = []
    for setting in settings:
        tracker = candidates.create(**setting, heading_alone=0.0, body_alone=0.0)
        fold.fitted.use(tracker)
        tracked = [tracker.track(z, modes=1).x for z, _ in fold.validation]
        found.append(error_outcome(space, fold, tracked))
    return found
