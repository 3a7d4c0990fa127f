"""The common part of trackers whose estimates are regressed on key poses."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import asdict
from typing import ClassVar, Self

import numpy as np
from sklearn.utils.validation import check_is_fitted

from silpose.core.parameters import FROM_0_TO_1, POSITIVE, SEED, SHARE, Constraints, one_of
from silpose.core.pose_space import SPACES
from silpose.core.random_states import RandomState, seed_of
from silpose.core.serialisation import (
    State,
    arrays_of,
    estimator_from,
    prefixed,
    unwrapped,
    without_prefix,
)
from silpose.core.types import Array, Examples
from silpose.tracking.base_tracker import Run, Tracker
from silpose.tracking.checks import check_table
from silpose.tracking.key_poses import KeyExamples, KeyPoseComparison, KeyPoses
from silpose.tracking.local_regression import regress_locally, weights_around
from silpose.tracking.silhouette_regressor import SilhouetteRegressor

SHARES: Mapping[str, slice] = {"heading_alone": slice(0, 2), "body_alone": slice(2, None)}
"""Columns of a pose, by the parameter that is their share regressed on the silhouette alone."""


class KeyPoseTracker(Tracker[Run]):
    """A tracker that weights key poses, on which the estimate is regressed.

    The estimate is (1 - s) x̂_local + s x̂_alone: locally weighted regression on key poses, and
    regression on the silhouette alone, where it resembles a key pose's. The share s is
    `heading_alone` in the columns of the heading, `body_alone` in the others, and lower for
    silhouettes that resemble none.

    Attributes
    ----------
    examples_ : KeyExamples
        Key poses and their descriptors.
    silhouette_alone_ : SilhouetteRegressor
    """

    constraints: ClassVar[Constraints] = {
        "space": one_of(*SPACES),
        "keep": SHARE,
        "pose_width": POSITIVE,
        "descriptor_width": POSITIVE,
        "damping": POSITIVE,
        "heading_alone": FROM_0_TO_1.or_none(),
        "body_alone": FROM_0_TO_1.or_none(),
        "frames_per_second": POSITIVE,
        "random_state": SEED,
    }
    _fitted: ClassVar[tuple[str, ...]]  # names of fitted arrays and numbers

    space: str
    keep: float
    pose_width: float
    descriptor_width: float
    damping: float
    heading_alone: float | None
    body_alone: float | None
    random_state: RandomState

    def key_poses(self, takes: Examples) -> KeyPoses:
        """Cluster the poses of training takes ``(z, x)``."""
        space = SPACES[self.space]
        check_table(takes[0][1], f"poses in the space {self.space!r}", len(space.columns))
        return KeyPoses.fit(takes, space, self.keep, seed_of(self.random_state))

    @abstractmethod
    def track_separately(self, z: Array) -> tuple[Array, Array]:
        """Track a take, and keep both parts of the estimates, of which they are a sum.

        Parameters
        ----------
        z : ndarray, shape (F, d)

        Returns
        -------
        local : ndarray, shape (F, D)
            Regressed on key poses.
        change : ndarray, shape (F, D)
            What a share of 1 that is regressed on the silhouette alone adds: with shares s,
            estimates are local + s · change.
        """

    def _use_key_poses(self, keys: KeyPoses) -> None:
        self.examples_, self.silhouette_alone_ = keys.examples, keys.silhouette_alone

    @property
    def columns(self) -> tuple[int, int]:
        """Number of columns of descriptors and of poses, d and D."""
        return len(self.examples_.whitening), len(self.examples_.mean)

    @property
    def _shares(self) -> Array:
        """Share of each column that is regressed on the silhouette alone, shape (D,)."""
        shares = np.zeros(len(self.examples_.mean))
        for name, columns in SHARES.items():
            shares[columns] = getattr(self, name) or 0.0  # None: not chosen
        return shares

    def regress(self, weights: Array, comparison: KeyPoseComparison) -> Array:
        """Estimate poses.

        Parameters
        ----------
        weights : ndarray, shape (F, K)
            Weights of key poses; each frame's sum to 1.
        comparison : KeyPoseComparison
            What is seen in the same frames.

        Returns
        -------
        x : ndarray, shape (F, D)
        """
        local, change = self.regress_separately(weights, comparison)
        return local + self._shares * change

    def regress_separately(
        self, weights: Array, comparison: KeyPoseComparison
    ) -> tuple[Array, Array]:
        """Estimate poses as `regress` does; return the parts that `track_separately` does."""
        own, seen = self.examples_, ~comparison.blank
        rows = zip(weights, comparison.descriptors, strict=True)
        local = np.array(
            [regress_locally(w, own.poses, own.descriptors, z, self.damping) for w, z in rows]
        )
        alone, distances = self.silhouette_alone_, comparison.distances[seen]
        change = np.zeros_like(local)
        change[seen] = alone.confidence(distances) * (alone.predict(distances) - local[seen])
        return local * own.scale + own.mean, change * own.scale

    def regress_around(self, rough: Array, z: Array) -> Array:
        """Refine rough poses where there is something to see.

        Parameters
        ----------
        rough : ndarray, shape (F, D)
        z : ndarray, shape (F, d)

        Returns
        -------
        x : ndarray, shape (F, D)
        """
        local, change = self.regress_around_separately(rough, z)
        return local + self._shares * change

    def regress_around_separately(self, rough: Array, z: Array) -> tuple[Array, Array]:
        """Refine as `regress_around` does; return the parts that `track_separately` does."""
        local, change = rough.copy(), np.zeros_like(rough)
        seen = np.isfinite(z).all(axis=1)
        if seen.any():
            comparison = self.examples_.compare(z[seen])
            widths = self.pose_width, self.descriptor_width
            weights = weights_around(rough[seen], comparison, self.examples_, *widths)
            local[seen], change[seen] = self.regress_separately(weights, comparison)
        return local, change

    def to_arrays(self) -> State:
        """Return parameters and fitted attributes as arrays, numbers and strings."""
        check_is_fitted(self)
        own = arrays_of(self, self._fitted) | prefixed("examples", asdict(self.examples_))
        return own | prefixed("silhouette_alone", asdict(self.silhouette_alone_))

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore a tracker from the result of `to_arrays`."""
        tracker = estimator_from(cls, state, cls._fitted)
        tracker.examples_ = KeyExamples(**unwrapped(without_prefix("examples", state)))
        alone = unwrapped(without_prefix("silhouette_alone", state))
        tracker.silhouette_alone_ = SilhouetteRegressor(**alone)
        return tracker
