"""Second-order linear dynamics of pose: Eq. 8."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike
from sklearn.base import BaseEstimator
from sklearn.utils.validation import check_is_fitted

from silpose.core.errors import InputError
from silpose.core.parameters import (
    POSITIVE,
    POSITIVE_INTEGER,
    Constraints,
    check_parameters,
    check_values,
)
from silpose.core.serialisation import State, arrays_of, estimator_from
from silpose.core.types import Array
from silpose.regression.moments import Moments
from silpose.tracking.checks import numbers
from silpose.tracking.takes import checked_poses

_FITTED = ("mean_", "scale_", "coef_")


class SecondOrderDynamics(BaseEstimator):
    """Predictions x̌_t = (I + A)(2 x_{t-1} - x_{t-2}) + B x_{t-1} (Eq. 8).

    Poses are centred and at unit variance, so that A = B = 0, to which heavy damping leads, is
    constant velocity.

    Parameters
    ----------
    damping : float, default=10.0
        λ of the penalty λ (‖A‖² + ‖B‖²).

    Attributes
    ----------
    mean_, scale_ : ndarray, shape (D,)
        By which poses are centred and scaled.
    coef_ : ndarray, shape (2 D, D)
        Aᵀ above Bᵀ.

    References
    ----------
    A. Agarwal, B. Triggs, "Recovering 3D human pose from monocular images", IEEE TPAMI 2006,
    section V.
    """

    constraints: ClassVar[Constraints] = {"damping": POSITIVE}

    def __init__(self, damping: float = 10.0) -> None:
        self.damping = damping

    def fit(self, poses: Sequence[ArrayLike], y: object = None) -> Self:
        """Regress each pose on the two before it.

        Parameters
        ----------
        poses : sequence of array-like, each (F, D)
            Poses of each take; takes of fewer than three frames are left out.
        y : None
            Ignored.

        Raises
        ------
        InputError
            If no take has three frames, or one cannot be used.
        """
        check_parameters(self)
        takes = checked_poses(poses)
        if not any(len(take) > 2 for take in takes):
            raise InputError("dynamics need a take of three frames or more")
        whole = Moments.total(Moments.of_outputs(take) for take in takes if len(take))
        self.mean_, (self.scale_, _) = whole.mean_y, whole.scales
        count = len(self.mean_)
        gram, target = self.damping * np.eye(2 * count), np.zeros((2 * count, count))
        for take in takes:
            if len(take) > 2:
                states, changes = self._steps((take - self.mean_) / self.scale_)
                gram += states.T @ states
                target += states.T @ changes
        self.coef_ = np.linalg.solve(gram, target)
        return self

    @staticmethod
    def _steps(take: Array) -> tuple[Array, Array]:
        """Return regression inputs, and outputs: what constant velocity leaves to explain."""
        straight = 2 * take[1:-1] - take[:-2]
        return np.hstack([straight, take[1:-1]]), take[2:] - straight

    def predict(self, previous: ArrayLike, before: ArrayLike) -> Array:
        """Predict the pose after two.

        Parameters
        ----------
        previous, before : array-like, shape (..., D)
            x_{t-1} and x_{t-2}.

        Returns
        -------
        predicted : ndarray, shape (..., D)
        """
        check_is_fitted(self)
        last, older = ((self._poses(x) - self.mean_) / self.scale_ for x in (previous, before))
        straight = 2 * last - older
        ahead = straight + np.concatenate([straight, last], axis=-1) @ self.coef_
        return ahead * self.scale_ + self.mean_

    def predict_within(self, previous: Array, before: Array, reach: float) -> Array:
        """Predict as `predict` does, and keep a diverging state bounded.

        Parameters
        ----------
        previous, before : ndarray, shape (..., D)
        reach : float
            Largest difference from the mean pose, in standard deviations.
        """
        bound = reach * self.scale_
        return np.clip(self.predict(previous, before), self.mean_ - bound, self.mean_ + bound)

    def run(self, start: ArrayLike, frames: int) -> Array:
        """Predict in open loop: poses (frames, D) that follow from the first two alone.

        Parameters
        ----------
        start : array-like, shape (2, D)
        frames : int
        """
        check_values("frames", POSITIVE_INTEGER, frames)
        poses = list(self._poses(start)[:2])
        if len(poses) < 2:
            raise InputError("dynamics start from two poses: give the first two")
        while len(poses) < frames:
            poses.append(self.predict(poses[-1], poses[-2]))
        return np.array(poses[:frames])

    def _poses(self, x: ArrayLike) -> Array:
        """Poses (..., D) as an array."""
        poses = numbers(x, "poses")
        if poses.shape[-1:] != self.mean_.shape:
            raise InputError(f"poses have shape {poses.shape}: expected (…, {len(self.mean_)})")
        return poses

    def to_arrays(self) -> State:
        """Return parameters and fitted attributes as arrays and numbers."""
        check_is_fitted(self)
        return arrays_of(self, _FITTED)

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore dynamics from the result of `to_arrays`."""
        return estimator_from(cls, state, _FITTED)
