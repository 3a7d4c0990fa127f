"""The authors' own data: histograms of shape contexts and joint positions, without masks.

The file ``ankurDataPoseSilhouette.mat``, which GPmat and other projects distribute: 1927 training
frames in eight sequences, and the 418 test frames of the paper's spiral walk.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy.io import loadmat
from scipy.io.matlab import MatReadError
from scipy.spatial.transform import Rotation

from silpose.core.errors import InputError
from silpose.core.pose_space import AUTHORS_JOINTS
from silpose.core.stages import timed
from silpose.core.types import Array
from silpose.dataset.synthesis import Renderer
from silpose.dataset.take import Dataset, DatasetSource, Take

LENGTHS = (100, 236, 69, 66, 483, 577, 238, 158)
"""Frames of the training sequences, in the order of the file."""

FRAMES_PER_SECOND = 15.0
"""Not documented with the data; a walking cycle of 17 frames takes about 1.1 s."""

# The root's children at rest, in the authors' skeleton: left hip, right hip, chest (whose offset
# is turned by the abdomen's fixed 20.556639 degrees).
_CHILDREN = [13, 16, 2]
_REST = np.array([[4.500466, -6.400484, -1.832696], [-4.500466, -6.400484, -1.832696], [0, 0, 0]])
_REST[2] = Rotation.from_euler("x", 20.556639, degrees=True).apply([0, 5.018152, -1.882228])
_FLIP = np.array([1, -1, -1])  # y and z are upside down in the file


class AgarwalFile(DatasetSource):
    """The authors' own data, read from their file.

    Parameters
    ----------
    path : str or Path
        The file ``ankurDataPoseSilhouette.mat``.
    """

    name = "agarwal"
    rendered = False

    def __init__(self, path: str | Path) -> None:
        self.path = path

    @timed("masks")
    def load(self, renderer: Renderer | None = None) -> Dataset:
        """Read all sequences; there are none for validation.

        Parameters
        ----------
        renderer : Renderer, optional
            Ignored.

        Returns
        -------
        dataset : Dataset

        Raises
        ------
        InputError
            If the file is missing or another one.
        """
        y, z, y_test, z_test = self._arrays()
        ends = np.cumsum(LENGTHS)
        train = [
            _take(f"train_{k + 1}", z[end - length : end], y[end - length : end])
            for k, (length, end) in enumerate(zip(LENGTHS, ends, strict=True))
        ]
        return Dataset(self.name, AUTHORS_JOINTS, train, [], [_take("test", z_test, y_test)])

    def _arrays(self) -> list[Array]:
        path = Path(self.path)
        if not path.is_file():
            raise InputError(f"there is no file '{path}': give ankurDataPoseSilhouette.mat")
        shapes = {"Y": (1927, 100), "Z": (1927, 63), "Y_test": (418, 100), "Z_test": (418, 63)}
        try:
            content = loadmat(path, variable_names=list(shapes))
        except (ValueError, TypeError, NotImplementedError, MatReadError) as error:
            raise InputError(
                f"'{path}' is no MATLAB file that can be read: give ankurDataPoseSilhouette.mat"
            ) from error
        for name, shape in shapes.items():
            found = np.shape(content.get(name, ()))
            if found != shape:
                raise InputError(
                    f"'{path}' is not the authors' data: {name} has shape {found}, not {shape}; "
                    "give ankurDataPoseSilhouette.mat"
                )
        return [np.asarray(content[name], dtype=float) for name in shapes]


def _take(name: str, positions: Array, histograms: Array) -> Take:
    joints = positions.reshape(len(positions), -1, 3) * _FLIP
    joints -= joints[:, :1]
    theta = heading(joints)
    moving = joints[:, AUTHORS_JOINTS.fixed :].reshape(len(joints), -1)
    x = np.column_stack([np.cos(theta), np.sin(theta), moving])
    z = histograms / histograms.sum(axis=1, keepdims=True)
    return Take(name, "agarwal", FRAMES_PER_SECOND, x, None, np.zeros((len(x), 3)), z)


def heading(joints: Array) -> Array:
    """Compute the heading from joint positions.

    The rigid fit of hips and chest to their rest positions is exact in these data; its rotation is
    Rx · Rz · Ry(θ).

    Parameters
    ----------
    joints : ndarray, shape (F, 21, 3)
        Relative to the root.

    Returns
    -------
    heading : ndarray, shape (F,)
        Radians.
    """
    u, _, vt = np.linalg.svd(np.swapaxes(joints[:, _CHILDREN], 1, 2) @ _REST)
    u[:, :, 2] *= np.linalg.det(u @ vt)[:, None]
    rotation = u @ vt
    return np.arctan2(rotation[:, 0, 2], rotation[:, 0, 0])
