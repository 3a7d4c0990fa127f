"""A perspective camera in front of the person."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.core.errors import InputError
from silpose.core.pose_space import wrap_degrees
from silpose.core.types import Array


@dataclass(frozen=True)
class Camera:
    """A pinhole camera on the world's +Z side of its target, its image upright.

    Attributes
    ----------
    focal_length : float, default=2.0
        Image heights.
    elevation : float, default=5.0
        Degrees by which the camera looks down, -80 to 80.
    distance : float, default=4.5
        Metres from the camera to its target.
    width, height : int, default=256
        Pixels.
    follow : bool, default=True
        Whether the target is the person's root, which then stays on the optical axis; otherwise
        it is the fixed middle of the person's path.
    azimuth : float, default=0.0
        Degrees by which the camera stands away from the world's +Z side, towards +X. Offsets and
        headings are in a world that is turned so that the camera is on the +Z side.
    orbit : float, default=0.0
        Degrees per second by which the camera circles its target: orbiting a straight walk shows
        as many headings as a turning walk.

    Raises
    ------
    InputError
        If a length or a number of pixels is not positive, or the elevation out of its range.
    """

    focal_length: float = 2.0
    elevation: float = 5.0
    distance: float = 4.5
    width: int = 256
    height: int = 256
    follow: bool = True
    azimuth: float = 0.0
    orbit: float = 0.0

    def __post_init__(self) -> None:
        for name in ("focal_length", "distance", "width", "height"):
            if getattr(self, name) <= 0:
                raise InputError(f"the camera's {name} must be positive, not {getattr(self, name)}")
        if not -80 <= self.elevation <= 80:
            raise InputError(
                f"the camera's elevation must be from -80 to 80 degrees, not {self.elevation}"
            )

    @property
    def focal_pixels(self) -> float:
        """Focal length in pixels."""
        return self.focal_length * self.height

    @property
    def position(self) -> Array:
        """Position relative to the target, metres, shape (3,)."""
        e = np.deg2rad(self.elevation)
        return self.distance * np.array([0.0, np.sin(e), np.cos(e)])

    @property
    def orientation(self) -> Array:
        """World axes of the camera's right, down and forward as columns, shape (3, 3)."""
        e = np.deg2rad(self.elevation)
        forward = -np.array([0.0, np.sin(e), np.cos(e)])
        right = np.array([1.0, 0.0, 0.0])
        return np.stack([right, np.cross(forward, right), forward], axis=1)

    def place(
        self, root_position: ArrayLike, heading: ArrayLike, seconds: ArrayLike = 0.0
    ) -> tuple[Array, Array]:
        """Transform a walk from the world to where this camera sees it.

        Parameters
        ----------
        root_position : array-like, shape (F, 3)
            Metres, in the world.
        heading : array-like, shape (F,)
            Degrees, in the world.
        seconds : float or array-like, shape (F,), default=0.0
            Time since the walk began.

        Returns
        -------
        offset : ndarray, shape (F, 3)
            Root relative to the target, metres.
        heading : ndarray, shape (F,)
            Relative to the direction from the person to the camera, degrees.
        """
        root_position = np.asarray(root_position, dtype=float)
        azimuth = self.azimuth + self.orbit * np.asarray(seconds, dtype=float)
        heading = np.asarray(heading, dtype=float) - azimuth
        if self.follow:
            return np.zeros_like(root_position), wrap_degrees(heading)
        aim = (root_position.min(axis=0) + root_position.max(axis=0)) / 2
        x, y, z = (root_position - aim).T
        cosine, sine = np.cos(np.deg2rad(azimuth)), np.sin(np.deg2rad(azimuth))
        offset = np.stack([cosine * x - sine * z, y, sine * x + cosine * z], axis=1)
        to_camera = self.position - offset
        bearing = np.rad2deg(np.arctan2(to_camera[:, 0], to_camera[:, 2]))
        return offset, wrap_degrees(heading - bearing)

    def project(self, points: NDArray[np.floating]) -> NDArray[np.floating]:
        """Project points to pixels.

        Parameters
        ----------
        points : ndarray, shape (..., 3)
            Metres, relative to the target.

        Returns
        -------
        pixels : ndarray, shape (..., 2)
            x to the right, y down; NaN for points behind the camera.
        """
        dtype = points.dtype
        turned = (points - self.position.astype(dtype)) @ self.orientation.astype(dtype)
        depth = np.where(turned[..., 2:] > 0, turned[..., 2:], dtype.type(np.nan))
        centre = np.array([(self.width - 1) / 2, (self.height - 1) / 2], dtype=dtype)
        return dtype.type(self.focal_pixels) * turned[..., :2] / depth + centre
