"""Second-order linear dynamics of pose: Eq. 8."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator
from sklearn.utils.validation import check_is_fitted

from silpose.core.errors import InputError

Array = NDArray[np.float64]


class SecondOrderDynamics(BaseEstimator):
    """Predicts x̌_t = (I + A)(2 x_{t-1} - x_{t-2}) + B x_{t-1} (Eq. 8).

    Poses are centred and at unit variance, so that A = B = 0, to which heavy damping leads, is
    constant velocity.

    Parameters
    ----------
    damping : float
        λ of λ (‖A‖² + ‖B‖²).

    Attributes
    ----------
    mean_, scale_ : ndarray, shape (D,)
    coef_ : ndarray, shape (2 D, D)
        Aᵀ above Bᵀ.
    """

    def __init__(self, damping: float = 10.0) -> None:
        self.damping = damping

    def fit(self, poses: Sequence[ArrayLike], y: object = None) -> SecondOrderDynamics:
        """Regress each pose on the two before it.

        Parameters
        ----------
        poses : sequence of array-like, each (F, D)
            One per take; takes of less than three frames tell nothing.
        """
        if not self.damping > 0:
            raise InputError(f"damping must be positive, not {self.damping}")
        takes = [np.asarray(take, dtype=float) for take in poses]
        if not any(len(take) > 2 for take in takes):
            raise InputError("dynamics want a sequence of three frames or more")
        every = np.concatenate(takes)
        deviation = every.std(axis=0)
        self.mean_ = every.mean(axis=0)
        self.scale_ = np.where(deviation > 1e-10 * np.maximum(np.abs(self.mean_), 1), deviation, 1)
        steps = [self._steps((take - self.mean_) / self.scale_) for take in takes if len(take) > 2]
        states, changes = (np.concatenate(part) for part in zip(*steps, strict=True))
        gram = states.T @ states
        gram.flat[:: len(gram) + 1] += self.damping
        self.coef_ = np.linalg.solve(gram, states.T @ changes)
        return self

    @staticmethod
    def _steps(take: Array) -> tuple[Array, Array]:
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
        last, older = (
            (np.asarray(x, dtype=float) - self.mean_) / self.scale_ for x in (previous, before)
        )
        straight = 2 * last - older
        ahead = straight + np.concatenate([straight, last], axis=-1) @ self.coef_
        return ahead * self.scale_ + self.mean_

    def run(self, start: ArrayLike, frames: int) -> Array:
        """Let go: poses (frames, D) that follow from the first two alone, never corrected."""
        poses = [np.asarray(x, dtype=float) for x in np.asarray(start)[:2]]
        while len(poses) < frames:
            poses.append(self.predict(poses[-1], poses[-2]))
        return np.array(poses[:frames])


LEARNT_DYNAMICS = ("mean_", "scale_", "coef_")
