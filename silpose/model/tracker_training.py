"""What tracking experiments begin with: trackers and baselines, each fitted when first needed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np
from sklearn.base import clone

from silpose.core.errors import InputError
from silpose.core.stages import timed
from silpose.core.types import Array, Examples, Metrics
from silpose.evaluation import baselines, measure
from silpose.model.training import DescribedDataset
from silpose.regression import ChosenMixture, RegressionCandidates, RidgeRegressor
from silpose.tracking import (
    GIVEN,
    BeliefTracker,
    Estimate,
    MultipleHypothesisTracker,
    SecondOrderDynamics,
    SinglePoseTracker,
    TrackerSelection,
    TrackingCandidates,
    choose_belief_tracker,
    choose_dynamics,
    choose_hypothesis_tracker,
    choose_single_pose_tracker,
    choose_smoothing_baselines,
)


@dataclass(frozen=True)
class TrackerTraining:
    """A described dataset, and the models that are fitted to it when they are first needed.

    Attributes
    ----------
    described : DescribedDataset
    regression : RegressionCandidates
        Single-image regressors, and the values to choose their settings from.
    tracking : TrackingCandidates
        Trackers likewise.
    selection : TrackerSelection
        Account of the settings that have been chosen for trackers.

    See Also
    --------
    TrackerTraining.of : Creates one.
    """

    described: DescribedDataset
    regression: RegressionCandidates
    tracking: TrackingCandidates
    selection: TrackerSelection

    @classmethod
    def of(
        cls,
        described: DescribedDataset,
        regression: RegressionCandidates,
        tracking: TrackingCandidates,
    ) -> Self:
        """Prepare the training of trackers.

        Parameters
        ----------
        described : DescribedDataset
        regression : RegressionCandidates
        tracking : TrackingCandidates

        Raises
        ------
        InputError
            If a test take is too short to be tracked.
        """
        for take, (_, x) in zip(described.data.test, described.test, strict=True):
            if len(x) <= GIVEN:
                raise InputError(
                    f"test take '{take.name}' of {len(x)} frames is too short to be tracked: "
                    f"choose one of more than {GIVEN} by 'dataset.test=[NAME]'"
                )
        selection = TrackerSelection(
            described.train,
            described.validation,
            described.data.space,
            described.frames_per_second,
            described.groups,
            known=described.known,
        )
        return cls(described, regression, tracking, selection)

    @cached_property
    def ridge(self) -> RidgeRegressor:
        """The single-image regressor."""
        return self.described.choose_ridge(self.regression)

    @cached_property
    def mixture(self) -> ChosenMixture:
        """The mixture of regressors."""
        return self.described.choose_mixture(self.regression.mixture, self.ridge)

    @cached_property
    def dynamics(self) -> SecondOrderDynamics:
        """The dynamics of Eq. 8."""
        return choose_dynamics(self.selection, self.tracking.dynamics)

    @cached_property
    def tracker(self) -> BeliefTracker:
        """The tracker with a belief over key poses."""
        return choose_belief_tracker(self.selection, self.tracking.tracker)

    @cached_property
    def state_sensitive(self) -> SinglePoseTracker:
        """The paper's tracker."""
        return choose_single_pose_tracker(
            self.selection,
            self.tracking.state_sensitive,
            self.tracking.single_pose,
            self.dynamics,
        )

    @cached_property
    def hypotheses(self) -> MultipleHypothesisTracker:
        """The multiple hypothesis tracker."""
        return choose_hypothesis_tracker(
            self.selection, self.tracking.hypotheses, self.mixture, self.dynamics
        )

    @cached_property
    def baselines(self) -> dict[str, Estimate]:
        """What else makes single-image estimates smooth, by method."""
        return choose_smoothing_baselines(
            self.selection, self.tracking.baselines, self.ridge, self.dynamics
        )

    @timed("tracking")
    def state_sensitive_with(
        self, takes: Examples | None = None, **settings: object
    ) -> SinglePoseTracker:
        """Fit the paper's tracker anew, with some settings of its regressor changed.

        Parameters
        ----------
        takes : sequence of (z, x), optional
            Training takes; all if not given.
        **settings
            Parameters of `StateSensitiveRegressor`.
        """
        changed = {f"regressor__{name}": value for name, value in settings.items()}
        tracker = clone(self.state_sensitive).set_params(**changed)
        return tracker.fit(self.described.train if takes is None else takes)

    @property
    def lag(self) -> int:
        """Number of frames that estimates wait for, where they may wait."""
        return round(self.tracking.lag * self.selection.frames_per_second)

    @timed("tracking")
    def follow(self, estimators: Mapping[str, Estimate]) -> dict[str, list[Array]]:
        """Estimate the poses of each test take.

        Parameters
        ----------
        estimators : mapping of str to callable
            By method; given descriptors and the first true poses of a take.

        Returns
        -------
        tracks : dict of list of ndarray, each (F, D)
            By method.
        """
        return {
            method: [estimate(z, x[:GIVEN]) for z, x in self.described.test]
            for method, estimate in estimators.items()
        }

    @timed("evaluation")
    def measure(self, tracks: Mapping[str, Sequence[Array]]) -> Metrics:
        """Measure tracks and baselines on frames of which no tracker is given the pose.

        Parameters
        ----------
        tracks : mapping of str to sequence of ndarray, each (F, D)
            Estimates of each test take, by method.

        Returns
        -------
        metrics : dict of dict of float
            By method, then by name.
        """
        space = self.described.data.space
        z_train, x_train = self.described.joined("train")
        z = np.concatenate([z[GIVEN:] for z, _ in self.described.test])
        x = np.concatenate([x[GIVEN:] for _, x in self.described.test])
        estimates = baselines(space, z_train, x_train, z, x)
        estimates |= {m: np.concatenate([e[GIVEN:] for e in own]) for m, own in tracks.items()}
        return {m: measure(space, x, e, x_train) for m, e in estimates.items()}

    @timed("tracking")
    def validation_error(self, method: str) -> float | None:
        """Return the error on held-out takes of what was chosen for a method.

        See Also
        --------
        silpose.tracking.TrackerSelection.validation_error : It is computed only now if needed.
        """
        return self.selection.validation_error(method)

    def errors(self, tracks: Sequence[Array]) -> Array:
        """Return the distances from the truth in frames of which no tracker is given the pose.

        Parameters
        ----------
        tracks : sequence of ndarray, each (F, D)
            Estimates of each test take.

        Returns
        -------
        errors : ndarray, shape (n,)
            Of all test takes, one after the other.
        """
        pairs = zip(self.described.test, tracks, strict=True)
        distance = self.described.data.space.distance
        return np.concatenate([distance(x[GIVEN:], own[GIVEN:]) for (_, x), own in pairs])
