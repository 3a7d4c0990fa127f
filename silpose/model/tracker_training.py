"""What the tracking experiments begin with: single-image ridge, dynamics, a tracker."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.core.errors import InputError
from silpose.evaluation import baselines, measure
from silpose.experiments.setup import Components
from silpose.model.training import DescribedDataset, Examples, prepare
from silpose.recording.runs.run_folder import Run
from silpose.regression import Candidates, RidgeRegressor
from silpose.tracking import (
    GIVEN,
    BeliefTracker,
    Estimate,
    SecondOrderDynamics,
    Selection,
    SinglePoseTracker,
    TrackingSettings,
    choose_dynamics,
    choose_joint,
    choose_tracker,
)

Array = NDArray[np.float64]


@dataclass(frozen=True)
class TrackerTraining:
    """A described dataset and what is learnt from it, when it is first asked for.

    Attributes
    ----------
    described : DescribedDataset
    candidates : Candidates
        Settings of the single-image regressor.
    selection : Selection
    settings : TrackingSettings
    """

    described: DescribedDataset
    candidates: Candidates
    selection: Selection
    settings: TrackingSettings

    @cached_property
    def ridge(self) -> RidgeRegressor:
        """The single-image regressor."""
        return self.described.learn_ridge(self.candidates)

    @cached_property
    def tracker(self) -> BeliefTracker:
        """The belief tracker."""
        return choose_tracker(self.selection, self.settings.tracker)

    @cached_property
    def dynamics(self) -> SecondOrderDynamics:
        """The dynamics of Eq. 8."""
        return choose_dynamics(self.selection, self.settings.dynamics)

    @cached_property
    def joint(self) -> SinglePoseTracker:
        """The paper's tracker."""
        return choose_joint(self.selection, self.settings.joint, self.dynamics)

    def joint_with(
        self, sequences: Examples | None = None, **settings: object
    ) -> SinglePoseTracker:
        """Fit the paper's tracker anew, some of its regressor's settings changed.

        Parameters
        ----------
        sequences : sequence of (z, x), optional
            Instead of all training sequences.
        **settings
            Of `StateSensitiveRegressor`.
        """
        regressor = clone(self.joint.regressor).set_params(**settings)
        tracker = SinglePoseTracker(clone(self.dynamics), regressor, self.joint.samples)
        return tracker.fit(self.described.train if sequences is None else sequences)

    @property
    def lag(self) -> int:
        """Frames that may be waited for."""
        return round(self.settings.tracker.lag * self.selection.frames_per_second)

    def follow(self, estimators: Mapping[str, Estimate]) -> dict[str, list[Array]]:
        """Estimate the poses of each test sequence, its first true ones at hand."""
        return {
            method: [estimate(z, x[:GIVEN]) for z, x in self.described.test]
            for method, estimate in estimators.items()
        }

    def measure(self, tracks: Mapping[str, list[Array]]) -> dict[str, dict[str, float]]:
        """Errors of baselines and `tracks` over the frames of which nobody is given the pose."""
        described, space = self.described, self.described.data.space
        unknown = [(z[GIVEN:], x[GIVEN:]) for z, x in described.test]
        z_train, x_train = (np.concatenate(part) for part in zip(*described.train, strict=True))
        z, x = (np.concatenate(part) for part in zip(*unknown, strict=True))
        estimates = baselines(space, z_train, x_train, z, x)
        estimates |= {m: np.concatenate([e[GIVEN:] for e in own]) for m, own in tracks.items()}
        return {m: measure(space, x, e, x_train) for m, e in estimates.items()}


def learn_to_track(rooms: Components, run: Run) -> TrackerTraining:
    """Prepare the data."""
    described = prepare(rooms, run)
    shortest = min((len(x) for _, x in described.test), default=0)
    if shortest <= GIVEN:
        raise InputError(f"a test sequence of {shortest} frames is too short to be tracked")
    rate = described.data.test[0].frames_per_second
    selection = Selection(
        described.train, described.validation, described.data.space, rate, described.groups
    )
    return TrackerTraining(described, rooms.candidates, selection, rooms.tracking)
