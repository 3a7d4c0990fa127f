"""The pose that is expected of the next frame, from the fits before it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from silpose.core.types import Array
from silpose.fitting.parameters import difference

_MOVES_ON = 0.5  # share of the last velocity that is expected to go on


@dataclass(frozen=True, eq=False)
class ExpectedPose:
    """A Gaussian around the last good fit moved on.

    Attributes
    ----------
    fitted : ndarray, shape (54,)
        Angles of the last good fit, radians.
    uncertainty : ndarray, shape (54, 54)
        Covariance of the fit, radians².
    velocity : ndarray, shape (54,)
        Change of the angles from the frame before, radians.
    change : ndarray, shape (54, 54)
        Covariance of a pose's change from frame to frame, radians².
    age : int, default=1
        Frames since the fit.
    """

    fitted: Array
    uncertainty: Array
    velocity: Array
    change: Array
    age: int = 1

    @classmethod
    def after(
        cls, before: ExpectedPose | None, fitted: Array, uncertainty: Array, change: Array
    ) -> ExpectedPose:
        """Expect a pose after a fit, which followed another if that is known."""
        velocity = np.zeros_like(fitted)
        if before is not None and before.age == 1:
            velocity = difference(fitted, before.fitted)
        return cls(fitted, uncertainty, velocity, change)

    def later(self, frames: int = 1) -> ExpectedPose:
        """Expect the pose some frames later, without a fit in between."""
        still = np.zeros_like(self.velocity)
        return ExpectedPose(self.fitted, self.uncertainty, still, self.change, self.age + frames)

    @property
    def mean(self) -> Array:
        """Expected angles, radians, shape (54,)."""
        return self.fitted + _MOVES_ON * self.velocity

    @property
    def covariance(self) -> Array:
        """Of what is expected, radians², shape (54, 54)."""
        return self.uncertainty + self.age**2 * self.change

    @cached_property
    def precision(self) -> Array:
        """Inverse of the covariance, shape (54, 54)."""
        return np.linalg.inv(self.covariance).astype(float)

    def together_with(self, mean: Array, precision: Array) -> tuple[Array, Array]:
        """Multiply with another Gaussian; return mean and precision of the product."""
        both = self.precision + precision
        off = np.linalg.solve(both, precision @ difference(mean, self.mean))
        return self.mean + off, both
