"""Flat feet: bring the soles of a retargeted walk level where they carry the person.

A foot's pitch in a file's T-pose is a convention of its skeleton: soles that should be flat on
the ground in mid-stance come out pitched by up to seven degrees. The walk itself tells by how much.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

Array = NDArray[np.float64]

STANDING = 0.25
SWINGING = 0.6
"""Metres per second of the ankles between which a foot carries the body alone."""

FEWEST = 3
"""Frames of such stance, below which a foot is left as it is."""

LARGEST = 10.0
"""Degrees; what is more is how the person walks, on tiptoes say."""


def level_sole(foot: Array, ankle: Array, other_ankle: Array, frames_per_second: float) -> Array:
    """Take out of a foot's orientation its median pitch in mid-stance.

    Parameters
    ----------
    foot : ndarray, shape (F, 3, 3)
        Orientation in the world; the zero orientation has a level sole.
    ankle, other_ankle : ndarray, shape (F, 3)
        Metres.
    frames_per_second : float

    Returns
    -------
    foot : ndarray, shape (F, 3, 3)
        Unchanged if the take holds no walking.
    """
    if len(foot) < 2:
        return foot
    speed, other_speed = (
        np.linalg.norm(np.gradient(place, axis=0), axis=1) * frames_per_second
        for place in (ankle, other_ankle)
    )
    stance = (speed < STANDING) & (other_speed > SWINGING)
    if stance.sum() < FEWEST:
        return foot
    # Height of the foot's own forward axis: a turn of -pitch about x would raise it so.
    pitch = np.median(np.arcsin(np.clip(foot[stance, 1, 2], -1.0, 1.0)))
    if abs(pitch) > np.deg2rad(LARGEST):
        return foot
    return foot @ Rotation.from_rotvec([pitch, 0.0, 0.0]).as_matrix()
