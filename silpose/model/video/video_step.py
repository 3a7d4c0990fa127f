"""`VideoStep`: one frame of a film with everything that is known of it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Array, Mask
from silpose.model.poses import Poses


@dataclass(frozen=True, eq=False)
class VideoStep:
    """One frame of a film or of a camera, and the pose in it.

    Attributes
    ----------
    index : int
        Number of the frame in its source, from 0.
    time : float
        Seconds since the source's first frame.
    picture : ndarray of uint8, shape (H, W, 3), or None
        RGB; None where pictures are not kept.
    mask : ndarray of 0 and 1, shape (H, W)
        The person; blank where nobody is seen.
    seen : str
        State of the mask, as of `MaskedFrame`: ``person``, or what is doubtful.
    poses : Poses
        Of this one frame.
    skeleton : ndarray, shape (J, 2)
        Where the joints are in the picture, pixels; NaN where there is no pose.
    outline : ndarray, shape (N, 2)
        Closed outline of the fitted body in the picture, pixels; of no points where there is none.
    place : ndarray, shape (3,)
        Root in the world, metres: +X to the right in the picture, +Y up from the floor, +Z towards
        the camera; NaN where there is no pose.
    azimuth : float, default=0.0
        Azimuth of the direction from the person to the camera in that world, degrees: headings of
        poses are relative to it.
    scale : float, default=1.0
        Size of the person over that of the skeleton.
    latency : float or None, default=None
        Seconds from the picture to the pose, live; None where all frames were fitted together.
    dropped : int, default=0
        Frames of a camera that were dropped before this one.
    """

    index: int
    time: float
    picture: NDArray[np.uint8] | None
    mask: Mask
    seen: str
    poses: Poses
    skeleton: Array
    outline: Array
    place: Array
    azimuth: float = 0.0
    scale: float = 1.0
    latency: float | None = None
    dropped: int = 0
