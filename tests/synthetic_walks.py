"""Walks on a circle, whose descriptors determine the pose, but often not which leg is which."""

import numpy as np

from silpose.core.pose_space import ANGLES
from silpose.core.skeleton import ANGLES as NAMES


def walk_of(frames, seed=0, turns=2.0):
    """z (F, 24) and x (F, 55): heading and phase of the gait, each coded by 12 bumps."""
    rng = np.random.default_rng(seed)
    phase = rng.uniform(0, 2 * np.pi) + np.cumsum(rng.normal(0.45, 0.02, frames))
    heading = rng.uniform(-180, 180) + 360 * turns * np.arange(frames) / frames
    angles = np.zeros((frames, 54))
    angles[:, 0] = (heading + 180) % 360 - 180
    angles[:, NAMES.index("left_hip_x")] = 25 * np.sin(phase)
    angles[:, NAMES.index("right_hip_x")] = -25 * np.sin(phase)
    angles[:, NAMES.index("left_knee_x")] = 15 + 15 * np.cos(phase)
    centres = 2 * np.pi * np.arange(12) / 12
    facing, swinging, swapped = (
        np.exp(2 * np.cos(a[:, None] - centres))
        for a in (np.deg2rad(heading), phase, phase + np.pi)
    )
    clear = rng.random((frames, 1)) < 0.4
    z = np.hstack([facing, np.where(clear, swinging, (swinging + swapped) / 2)])
    z *= rng.uniform(0.8, 1.25, z.shape)
    return z / z.sum(axis=1, keepdims=True), ANGLES.from_angles(angles)
