"""How legs move on: what tells legs that pass each other from legs that bounce off.

From the side, a silhouette shows two legs, but hardly which is which. Over a quarter of a second
legs move far enough to tell: where they have just met, those of a walker are on their way apart.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from silpose.core.types import Array
from silpose.fitting.modes import LEGS, legs_swapped

FIT_ERROR = float(np.deg2rad(5.0) ** 2)
"""Variance of a fitted leg's angles, radians²."""

_SECONDS = 0.27  # between the poses that are compared


@dataclass(frozen=True, eq=False)
class LegMotion:
    """Linear prediction of the legs' angles from those at two times before.

    With a_t the 18 angles of hips, knees and ankles,

        a_t = A a_{t-2τ} + B a_{t-τ} + c + e,   e ~ N(0, Q).

    Attributes
    ----------
    weights : ndarray, shape (37, 18)
        A, B and c, below each other.
    covariance : ndarray, shape (18, 18)
        Q, radians².
    seconds : float
        τ.
    """

    weights: Array
    covariance: Array
    seconds: float

    @classmethod
    def learn(cls, takes: Sequence[Array], frames_per_second: float) -> LegMotion | None:
        """Learn from motion, as it is and with legs swapped, forwards and backwards.

        Parameters
        ----------
        takes : sequence of ndarray, each (F, 54)
            Angles in radians.
        frames_per_second : float

        Returns
        -------
        motion : LegMotion or None
            None if no take is long enough.
        """
        apart = max(1, round(_SECONDS * frames_per_second))
        long = [angles for angles in takes if len(angles) > 2 * apart]
        if not long:
            return None
        legs = [a[::way, LEGS] for own in long for a in (own, legs_swapped(own)) for way in (1, -1)]
        z = np.concatenate([_before(own[: -2 * apart], own[apart:-apart]) for own in legs])
        y = np.concatenate([own[2 * apart :] for own in legs])
        # What is predicted from will be fitted poses, which err.
        errors = len(z) * FIT_ERROR * np.diag([1.0] * (2 * len(LEGS)) + [0.0])
        weights = np.linalg.solve(z.T @ z + errors, z.T @ y)
        off = y - z @ weights
        return cls(weights, off.T @ off / len(off), apart / frames_per_second)

    @property
    def precision(self) -> Array:
        """Inverse of the covariance of what a prediction from fitted poses is off, (18, 18)."""
        slopes = self.weights[:-1]
        whole = self.covariance + FIT_ERROR * (np.eye(len(LEGS)) + slopes.T @ slopes)
        return np.linalg.inv(whole).astype(np.float64)

    def predicted(self, earlier: Array, before: Array) -> Array:
        """Predict legs (..., 18) from those at two times before, each (..., 18)."""
        count = len(LEGS)
        a, b, c = self.weights[:count], self.weights[count:-1], self.weights[-1]
        predicted: Array = earlier @ a + before @ b + c
        return predicted


def _before(earlier: Array, before: Array) -> Array:
    return np.concatenate([earlier, before, np.ones((*before.shape[:-1], 1))], axis=-1)
