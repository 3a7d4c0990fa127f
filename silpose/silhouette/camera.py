"""A perspective camera before the person."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.core.errors import InputError
from silpose.core.pose_space import wrap_degrees

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Camera:
    """A pinhole camera on the world's +Z side of what it looks at, its image upright.

    Attributes
    ----------
    focal_length : float
        In image heights.
    elevation : float
        Degrees by which the camera looks down.
    distance : float
        Metres from the camera to what it looks at.
    width, height : int
        Pixels.
    follow : bool
        Whether the camera moves with the person, whose root then stays on the optical axis;
        else it stands still and looks at the middle of the person's path.
    azimuth : float
        Degrees by which it stands away from the world's +Z side, towards +X. Everything else is
        said in a world that is turned so that the camera is on the +Z side.
    orbit : float
        Degrees a second by which it goes round what it looks at: orbiting a straight walk shows
        as many headings as a turning one.
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
            raise InputError(f"the camera's elevation is -80 to 80 degrees, not {self.elevation}")

    @property
    def focal_pixels(self) -> float:
        """Focal length in pixels."""
        return self.focal_length * self.height

    @property
    def position(self) -> Array:
        """Where it stands relative to what it looks at, shape (3,), metres."""
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
        """See a walk as this camera does.

        Parameters
        ----------
        root_position : array-like, shape (F, 3)
            Metres, in the world.
        heading : array-like, shape (F,)
            Degrees, in the world.
        seconds : float or array-like, shape (F,)
            Since the walk began.

        Returns
        -------
        offset : ndarray, shape (F, 3)
            Of the root from what the camera looks at, metres.
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
        """Pixel coordinates (x right, y down), shape (..., 2), of points (..., 3) in metres.

        Points behind the camera come out as NaN.
        """
        dtype = points.dtype
        turned = (points - self.position.astype(dtype)) @ self.orientation.astype(dtype)
        depth = np.where(turned[..., 2:] > 0, turned[..., 2:], dtype.type(np.nan))
        centre = np.array([(self.width - 1) / 2, (self.height - 1) / 2], dtype=dtype)
        return dtype.type(self.focal_pixels) * turned[..., :2] / depth + centre
