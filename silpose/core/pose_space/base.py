"""The interface of all pose spaces."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.errors import InputError
from silpose.core.types import Array, Indices


def wrap_degrees(angles: ArrayLike) -> Array:
    """Wrap angles to [-180, 180)."""
    return (np.asarray(angles, dtype=float) + 180.0) % 360.0 - 180.0


def wraps(values: Array, turn: float = 360.0) -> Indices:
    """Find the values (F,) before which numbers that go around have begun their turn again."""
    return 1 + np.flatnonzero(np.abs(np.diff(values)) > turn / 2)


class PoseSpace(ABC):
    """Meaning of a pose vector's columns, of which the first two are cos and sin of the heading.

    Attributes
    ----------
    name : str
        Identifies the space in a saved model.
    columns : tuple of str
        One name per column of x.
    angle_names : tuple of str
        Names of what `angles` returns, the heading first.
    metrics : tuple of str
        The measures of `silpose.evaluation` that are defined here, the reported one first.
    parts : mapping of str to ndarray of int
        Columns of each body part.
    units : ndarray, shape (D,)
        One unit of the reported metric in each column: for cos and sin, a degree.
    joint_names : tuple of str
        Names of what `joints` returns.
    bones : tuple of (int, int)
        Pairs of joints that are joined by a line.
    """

    name: str
    columns: tuple[str, ...]
    angle_names: tuple[str, ...]
    metrics: tuple[str, ...]
    parts: Mapping[str, Indices]
    units: Array
    joint_names: tuple[str, ...]
    bones: tuple[tuple[int, int], ...]

    @staticmethod
    def heading(x: ArrayLike) -> Array:
        """Compute the heading from its cos and sin, of any norm.

        Parameters
        ----------
        x : array-like, shape (F, D)

        Returns
        -------
        heading : ndarray, shape (F,)
            Degrees, relative to the direction from the person to the camera.
        """
        x = np.asarray(x, dtype=float)
        return np.rad2deg(np.arctan2(x[..., 1], x[..., 0]))

    @staticmethod
    def heading_norm(x: ArrayLike) -> Array:
        """Norm of (cos, sin), shape (F,): 1 for a true pose, lower for uncertain estimates."""
        x = np.asarray(x, dtype=float)
        return np.hypot(x[..., 0], x[..., 1])

    def angles(self, x: ArrayLike) -> Array:
        """Angles that a pose vector holds, degrees, shape (F, A), the heading first."""
        return self.heading(x)[..., None]

    def angle_errors(self, x: ArrayLike, other: ArrayLike) -> Array:
        """Absolute differences of the angles, degrees, shape (F, A), each at most 180."""
        return np.abs(wrap_degrees(self.angles(x) - self.angles(other)))

    def rotations(self, x: ArrayLike) -> Array:
        """Rotation of each joint relative to its parent, shape (F, 18, 3, 3).

        Raises
        ------
        InputError
            If poses are joint positions, from which rotations do not follow.
        """
        raise InputError(
            f"poses of the space '{self.name}' are joint positions and have no rotations: "
            "use a model that was trained on motion"
        )

    @abstractmethod
    def joints(self, x: ArrayLike) -> Array:
        """Joint positions, metres, shape (F, J, 3), the root at the origin."""

    def standing_height(self, x: ArrayLike) -> Array:
        """Height of the root above the ground of a standing pose, metres, shape (F,)."""
        return -self.joints(x)[..., 1].min(axis=-1)

    @abstractmethod
    def distance(self, x: ArrayLike, other: ArrayLike) -> Array:
        """Distance under the reported metric, shape (F,); the arguments broadcast."""

    def pairwise(self, x: ArrayLike, other: ArrayLike) -> Array:
        """Distance of every pose (F, D) to every other one (n, D), shape (F, n)."""
        other = np.asarray(other)
        return np.stack([self.distance(row, other) for row in np.asarray(x)])

    @abstractmethod
    def part_distance(self, part: str, x: ArrayLike, other: ArrayLike) -> Array:
        """Distance of one body part, shape (F,).

        Parameters
        ----------
        part : str
            A key of `parts`.
        x, other : array-like, shape (F, d)
            The part's columns alone.
        """

    def _embedded(self, part: str, columns: ArrayLike) -> Array:
        """Pose vectors (F, D) that hold one part's columns, and zeros elsewhere."""
        columns = np.asarray(columns, dtype=float)
        x = np.zeros((*columns.shape[:-1], len(self.columns)))
        x[..., self.parts[part]] = columns
        return x


def metric_units(columns: tuple[str, ...]) -> Array:
    """One unit of the reported metric in each column: a degree for cos and sin, else 1."""
    return np.array([np.deg2rad(1.0) if c.startswith("heading") else 1.0 for c in columns])
