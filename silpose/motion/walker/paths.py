"""Paths on the ground: position and direction by the distance walked.

A direction is an azimuth in degrees: 0 faces +Z, and 90 faces +X, which is to the left.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.types import Array

_STEP = 0.01  # metres between points of the integration along a path


class Path(ABC):
    """A curve on the ground that starts at the world's origin."""

    @abstractmethod
    def direction(self, distance: ArrayLike) -> Array:
        """Direction of travel.

        Parameters
        ----------
        distance : array-like, shape (F,)
            Metres along the path.

        Returns
        -------
        direction : ndarray, shape (F,)
            Degrees, unwrapped.
        """

    def position(self, distance: ArrayLike) -> Array:
        """Position on the ground.

        Parameters
        ----------
        distance : array-like, shape (F,)
            Metres along the path, not negative.

        Returns
        -------
        position : ndarray, shape (F, 3)
            Metres, of height 0.
        """
        distance = np.asarray(distance, dtype=float)
        grid = np.arange(0.0, distance.max(initial=0.0) + 2 * _STEP, _STEP)
        azimuth = np.deg2rad(self.direction(grid[:-1] + _STEP / 2))
        steps = np.stack([np.sin(azimuth), np.zeros_like(azimuth), np.cos(azimuth)], axis=1)
        curve = np.concatenate([np.zeros((1, 3)), np.cumsum(steps * _STEP, axis=0)])
        return np.stack([np.interp(distance, grid, curve[:, c]) for c in range(3)], axis=1)


@dataclass(frozen=True)
class Straight(Path):
    """A straight line.

    Parameters
    ----------
    heading : float, default=0.0
        Direction, degrees.
    """

    heading: float = 0.0

    def direction(self, distance: ArrayLike) -> Array:
        """Direction of travel, degrees, shape (F,)."""
        return np.full(np.shape(distance), float(self.heading))


@dataclass(frozen=True)
class Spiral(Path):
    """A spiral whose radius of curvature changes in proportion to the angle turned.

    After its last turn it goes on as a circle.

    Parameters
    ----------
    start_radius : float, default=3.0
        Metres.
    end_radius : float, default=1.5
        Metres.
    turns : float, default=3.0
        Full turns from the first radius to the last.
    heading : float, default=0.0
        Direction at the start, degrees.
    left : bool, default=True
        Whether it turns left (the direction grows) or right.
    """

    start_radius: float = 3.0
    end_radius: float = 1.5
    turns: float = 3.0
    heading: float = 0.0
    left: bool = True

    @property
    def length(self) -> float:
        """Metres of path until the last turn is complete."""
        return (self.start_radius + self.end_radius) / 2 * self.turns * 2 * np.pi

    def direction(self, distance: ArrayLike) -> Array:
        """Direction of travel, degrees, shape (F,), unwrapped."""
        distance = np.asarray(distance, dtype=float)
        total = 2 * np.pi * self.turns
        shrink = (self.start_radius - self.end_radius) / total
        inside = np.minimum(distance, self.length)
        # Solves distance = start_radius * angle - shrink * angle ** 2 / 2 for the angle turned.
        root = np.sqrt(np.maximum(self.start_radius**2 - 2 * shrink * inside, 0.0))
        angle = 2 * inside / (self.start_radius + root)
        angle = angle + (distance - inside) / self.end_radius
        return self.heading + (1.0 if self.left else -1.0) * np.rad2deg(angle)


@dataclass(frozen=True)
class Circle(Path):
    """A circle.

    Parameters
    ----------
    radius : float, default=2.0
        Metres.
    heading : float, default=0.0
        Direction at the start, degrees.
    left : bool, default=True
        Whether it turns left or right.
    """

    radius: float = 2.0
    heading: float = 0.0
    left: bool = True

    def direction(self, distance: ArrayLike) -> Array:
        """Direction of travel, degrees, shape (F,), unwrapped."""
        sign = 1.0 if self.left else -1.0
        return self.heading + sign * np.rad2deg(np.asarray(distance, dtype=float) / self.radius)
