"""Motion as a file has it: its own joints, units and axes, before anything is concluded from it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation, Slerp

from silpose.core.types import Array

LARGEST_SIZE = 20_000_000
"""Most frames times nodes that are held: about two gigabytes for a motion."""


@dataclass(frozen=True)
class RawMotion:
    """A file's tree of joints and their motion, in the file's own units and axes.

    Attributes
    ----------
    file : str
        Named in errors and warnings.
    names : tuple of str, length J
        Joints, a parent before its children, and end sites as ``PARENT/end``.
    parents : tuple of int, length J
        Index of each node's parent, -1 for a root.
    offsets : ndarray, shape (J, 3)
        From the parent to the node where no joint is rotated; of nodes that move within their
        parent, the median.
    rotations : ndarray, shape (F, J, 3, 3)
        Rotation of each node in the world; an end site has its parent's.
    positions : ndarray, shape (F, J, 3)
        Position of each node in the world.
    frames_per_second : float
    up : str or None, default=None
        Axis that points up by the format's definition, ``x``, ``y``, ``z``, ``-x``, ``-y`` or
        ``-z``; None where the format does not say, as BVH.
    unit : float or None, default=None
        Metres per unit of length if the format or the file says it.
    format : str, default=""
        Name of the file's format: BVH, ASF/AMC or AMASS.
    notes : tuple of str, default=()
        What was assumed in reading, one sentence each, to be given as warnings.
    """

    file: str
    names: tuple[str, ...]
    parents: tuple[int, ...]
    offsets: Array
    rotations: Array
    positions: Array
    frames_per_second: float
    up: str | None = None
    unit: float | None = None
    format: str = ""
    notes: tuple[str, ...] = ()

    def __len__(self) -> int:
        return len(self.positions)

    def part(self, frames: slice) -> RawMotion:
        """Take some of the frames."""
        return replace(self, rotations=self.rotations[frames], positions=self.positions[frames])

    def at_zero(self) -> RawMotion:
        """Pose of one frame in which no joint is rotated and all are at their offsets."""
        positions = np.zeros((1, len(self.names), 3))
        for j, parent in enumerate(self.parents):
            positions[0, j] = self.offsets[j] + (positions[0, parent] if parent >= 0 else 0.0)
        rotations = np.tile(np.eye(3), (1, len(self.names), 1, 1))
        return replace(self, rotations=rotations, positions=positions)

    def local(self) -> tuple[Array, Array]:
        """Rotations (F, J, 3, 3) and positions (F, J, 3) relative to each node's parent."""
        rotations, positions = self.rotations.copy(), self.positions.copy()
        for j, parent in enumerate(self.parents):
            if parent >= 0:
                inverse = self.rotations[:, parent].transpose(0, 2, 1)
                step = self.positions[:, j] - self.positions[:, parent]
                rotations[:, j] = inverse @ self.rotations[:, j]
                positions[:, j] = np.einsum("fij,fj->fi", inverse, step)
        return rotations, positions

    def resampled(self, rate: float) -> RawMotion:
        """Interpolate at another frame rate.

        Parameters
        ----------
        rate : float
            Frames per second of the result, whose first frame is this motion's first.

        Returns
        -------
        motion : RawMotion
            Rotations relative to the parents are interpolated on the sphere, positions linearly.
        """
        if len(self) < 2 or rate == self.frames_per_second:
            return replace(self, frames_per_second=rate)
        time = np.arange(len(self)) / self.frames_per_second
        wanted = np.minimum(np.arange(0.0, time[-1] + 1e-9, 1 / rate), time[-1])
        rotations, positions = self.local()
        turned = np.empty((len(wanted), len(self.names), 3, 3))
        moved = np.empty((len(wanted), len(self.names), 3))
        for j in range(len(self.names)):
            turned[:, j] = Slerp(time, Rotation.from_matrix(rotations[:, j]))(wanted).as_matrix()
            for axis in range(3):
                moved[:, j, axis] = np.interp(wanted, time, positions[:, j, axis])
        world = world_from_local(self.parents, turned, moved)
        return replace(self, rotations=world[0], positions=world[1], frames_per_second=rate)


def world_from_local(
    parents: tuple[int, ...], rotations: Array, positions: Array
) -> tuple[Array, Array]:
    """Forward kinematics of any tree.

    Parameters
    ----------
    parents : tuple of int, length J
        A parent before its children; -1 for a root.
    rotations : ndarray, shape (F, J, 3, 3)
        Relative to the parent.
    positions : ndarray, shape (F, J, 3)
        In the parent's axes; a root's in the world.

    Returns
    -------
    rotations : ndarray, shape (F, J, 3, 3)
    positions : ndarray, shape (F, J, 3)
        In the world.
    """
    rotations, positions = rotations.copy(), positions.copy()
    for j, parent in enumerate(parents):
        if parent >= 0:
            turned = rotations[:, parent]
            positions[:, j] = positions[:, parent] + np.einsum(
                "fij,fj->fi", turned, positions[:, j]
            )
            rotations[:, j] = turned @ rotations[:, j]
    return rotations, positions
