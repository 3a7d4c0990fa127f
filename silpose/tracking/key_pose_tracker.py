"""What trackers have in common: their estimates are regressed on key poses."""

from __future__ import annotations

from dataclasses import asdict
from typing import Self

import numpy as np
from numpy.typing import NDArray
from sklearn.base import BaseEstimator
from sklearn.utils.validation import check_is_fitted

from silpose.core.errors import InputError
from silpose.core.pose_space import SPACES
from silpose.core.serialisation import (
    State,
    arrays_of,
    estimator_from,
    prefixed,
    unwrapped,
    without_prefix,
)
from silpose.tracking.key_poses import Examples, KeyExamples, KeyPoseComparison, KeyPoses
from silpose.tracking.local_regression import regress_locally
from silpose.tracking.silhouette_regressor import SilhouetteRegressor

Array = NDArray[np.float64]


class KeyPoseTracker(BaseEstimator):
    """A tracker that says which key poses are meant, for an estimate to be regressed on them.

    Attributes
    ----------
    examples_ : KeyExamples
        Key poses and their descriptors.
    silhouette_alone_ : SilhouetteRegressor
    """

    space: str  # parameters: the trackers explain them
    keep: float
    pose_width: float
    descriptor_width: float
    damping: float
    heading_alone: float
    body_alone: float
    random_state: int | None
    _learnt: tuple[str, ...]  # names of fitted arrays and numbers
    _positive: tuple[str, ...] = ("pose_width", "descriptor_width", "damping")

    def key_poses(self, sequences: Examples) -> KeyPoses:
        """Cluster the poses of training sequences ``(z, x)``."""
        return KeyPoses.of(sequences, SPACES[self.space], self.keep, self.random_state)

    def _compare_with(self, keys: KeyPoses) -> None:
        for name in self._positive:
            if not getattr(self, name) > 0:
                raise InputError(f"{name} must be positive, not {getattr(self, name)}")
        for name in ("heading_alone", "body_alone"):
            if not 0 <= getattr(self, name) <= 1:
                raise InputError(f"{name} is a share from 0 to 1, not {getattr(self, name)}")
        self.examples_, self.silhouette_alone_ = keys.examples, keys.silhouette_alone

    def _regressed(self, weights: Array, sight: KeyPoseComparison) -> Array:
        """Estimate poses (F, D), from weights (F, K) of key poses and from what is seen."""
        own, seen = self.examples_, ~sight.blank
        rows = zip(weights, sight.descriptors, strict=True)
        poses = np.array(
            [regress_locally(w, own.poses, own.descriptors, z, self.damping) for w, z in rows]
        )
        alone, distances = self.silhouette_alone_, sight.distances[seen]
        share = np.full(len(own.mean), self.body_alone)
        share[:2] = self.heading_alone
        poses[seen] += share * alone.trust(distances) * (alone.predict(distances) - poses[seen])
        return poses * own.scale + own.mean

    def to_arrays(self) -> State:
        """Give parameters and what was learnt, as arrays, numbers and words."""
        check_is_fitted(self)
        own = arrays_of(self, self._learnt) | prefixed("examples", asdict(self.examples_))
        return own | prefixed("silhouette_alone", asdict(self.silhouette_alone_))

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore what `state` gave."""
        tracker = estimator_from(cls, state, cls._learnt)
        tracker.examples_ = KeyExamples(**unwrapped(without_prefix("examples", state)))
        alone = unwrapped(without_prefix("silhouette_alone", state))
        tracker.silhouette_alone_ = SilhouetteRegressor(**alone)
        return tracker
