"""Prior of a pose: an estimate, and how such estimates err."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.stats import norm, t

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES as SPACE
from silpose.core.pose_space import wrap_degrees
from silpose.core.types import Array

CONTOUR_SECONDS = 0.11
"""Time in which errors of contours, by which no pose explains them fully, decay."""

_LEAST_DEG = 0.7  # standard deviation that no combination of angles goes below
_CHANGE_DEG = 1.5  # likewise of a change from frame to frame
_RATE = 12.0  # radians per second at which motion that comes and goes changes its velocity
_INTERVAL = 0.9  # in which the truth is as often as a prior of few performers says
_FEWEST = 3  # performers that there are taken to be at least
_WRONG_DEG = 60.0  # heading error from which a frame tells nothing of how good estimates err


@dataclass(frozen=True, eq=False)
class PosePrior:
    """Gaussian prior around an estimated pose, whose errors last over time.

    The error of the estimate at time t is Gaussian with the covariance S of held-out errors, and
    correlated in time: S (ρ + (1 - ρ) exp(-|t - t'| / τ)). The lasting share ρ is the person's
    own posture, which an estimator trained on others does not know.

    Attributes
    ----------
    covariance : ndarray, shape (54, 54)
        S, degrees².
    change : ndarray, shape (54, 54)
        Covariance of a true pose's velocity, (degrees per second)².
    lasting : float, default=0.3
        ρ, 0 up to 1.
    seconds : float, default=0.15
        τ.
    """

    covariance: Array
    change: Array
    lasting: float = 0.3
    seconds: float = 0.15

    def __post_init__(self) -> None:
        if np.shape(self.covariance) != (54, 54):
            raise InputError(
                f"a pose prior's covariance has shape (54, 54), not {np.shape(self.covariance)}"
            )
        if not 0 <= self.lasting < 1 or self.seconds <= 0:
            raise InputError(
                f"a pose prior lasts for a share below 1 and positive seconds, not {self.lasting} "
                f"and {self.seconds}"
            )

    @classmethod
    def from_errors(
        cls,
        true: Sequence[Array],
        estimated: Sequence[Array],
        frames_per_second: float,
        *,
        performers: Sequence[str] | None = None,
        lasting: float = 0.3,
        seconds: float = 0.15,
    ) -> PosePrior:
        """Learn the covariances from an estimator's errors on takes it was not trained on.

        The fewer performers there are, the less they tell of another one: if they are told, each
        counts as one observation, and the covariance is widened as Student's distribution is.

        Parameters
        ----------
        true, estimated : sequence of ndarray, each (F, 55)
            Poses of each take.
        frames_per_second : float
        performers : sequence of str, optional
            Who is seen in each take; by default there are as many as one needs.
        lasting, seconds : float
            As for the class.
        """
        angles = [SPACE.angles(x) for x in true]
        errors = np.concatenate(
            [wrap_degrees(a - SPACE.angles(e)) for a, e in zip(angles, estimated, strict=True)]
        )
        steps = np.concatenate([wrap_degrees(np.diff(a, axis=0)) for a in angles])
        velocity = steps * frames_per_second
        errors = errors[np.abs(errors[:, 0]) < _WRONG_DEG]
        if len(errors) < 54:
            raise InputError(
                f"a pose prior needs 54 held-out frames or more whose heading is right, not "
                f"{len(errors)}"
            )
        covariance = errors.T @ errors / len(errors)
        if performers is not None:
            covariance *= _widening(len(set(performers)))
        covariance += _LEAST_DEG**2 * np.eye(54)
        change = velocity.T @ velocity / len(velocity)
        return cls(covariance, change, lasting, seconds)

    def change_within(self, seconds: float) -> Array:
        """Covariance of a pose's change within some seconds, radians², shape (54, 54)."""
        degrees = self.change * seconds**2 + _CHANGE_DEG**2 * np.eye(54)
        return np.deg2rad(np.deg2rad(degrees))

    def bend_within(self, seconds: float) -> Array:
        """Covariance of the change of such changes, radians², shape (54, 54)."""
        degrees = self.change * seconds**2 * min(3.0, (_RATE * seconds) ** 2)
        degrees += 2 * _CHANGE_DEG**2 * np.eye(54)
        return np.deg2rad(np.deg2rad(degrees))

    @cached_property
    def precision(self) -> Array:
        """Inverse of the covariance, per radian², shape (54, 54)."""
        return np.linalg.inv(np.deg2rad(np.deg2rad(self.covariance)))


def _widening(performers: int) -> float:
    """Factor of a normal variance whose intervals are as wide as Student's."""
    end = (1 + _INTERVAL) / 2
    return float((t.ppf(end, max(performers, _FEWEST)) / norm.ppf(end)) ** 2)


def news(step_seconds: float, seconds: float) -> float:
    """Share of a frame's information that is not in the frames before it.

    Of a quantity that hardly changes, n observations whose errors decay in `seconds` tell as much
    as n (1 - φ) / (1 + φ) independent ones, φ = exp(-Δt / seconds).
    """
    phi = float(np.exp(-step_seconds / seconds))
    return (1 - phi) / (1 + phi)
