"""Levelling of the feet: soles of a retargeted walk are flat on the ground in mid-stance.

The pitch of a foot in a file's T-pose is a convention of its skeleton, so that soles that should be
flat are pitched by up to seven degrees. The pitch is estimated from the walk itself.
"""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from silpose.core.types import Array

STANDING = 0.25
"""Highest speed of the ankle of a standing foot, metres per second."""

SWINGING = 0.6
"""Lowest speed of the ankle of a swinging foot, metres per second."""

FEWEST = 3
"""Fewest frames of mid-stance from which a pitch is estimated."""

LARGEST = 10.0
"""Largest pitch that is removed, degrees; above it the person walks so, on tiptoe for example."""


def level_sole(foot: Array, ankle: Array, other_ankle: Array, frames_per_second: float) -> Array:
    """Remove the median pitch in mid-stance from a foot's orientation.

    Parameters
    ----------
    foot : ndarray, shape (F, 3, 3)
        Orientation in the world; the sole of the zero orientation is level.
    ankle, other_ankle : ndarray, shape (F, 3)
        Positions, metres.
    frames_per_second : float

    Returns
    -------
    foot : ndarray, shape (F, 3, 3)
        Unchanged if there is no walking.
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
    # Height of the foot's own forward axis: a rotation of -pitch about x would raise it so.
    pitch = np.median(np.arcsin(np.clip(foot[stance, 1, 2], -1.0, 1.0)))
    if abs(pitch) > np.deg2rad(LARGEST):
        return foot
    return foot @ Rotation.from_rotvec([pitch, 0.0, 0.0]).as_matrix()
