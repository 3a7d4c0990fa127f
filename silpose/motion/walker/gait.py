"""Gait analysis: the phase of walking, and its harmonics fitted to joint angles.

A walk is its mean posture plus the first two harmonics of the stride. At phase 0 the left ankle
passes the right one on its way forward, and a stride is 2 pi.

References
----------
N. F. Troje, "Decomposing biological motion", Journal of Vision 2002.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.signal import butter, sosfiltfilt

from silpose.core import skeleton
from silpose.core.types import Array
from silpose.motion.motion import Motion

STEP_SECONDS = (0.35, 0.9)
"""Shortest and longest step (half a stride) of steady walking, seconds."""

STEP_LENGTH = 0.25
"""Smallest distance between the ankles that a step must reach, metres."""


@dataclass(frozen=True)
class Steps:
    """A stretch of uninterrupted steps.

    Attributes
    ----------
    angles : ndarray, shape (F, 54)
        Degrees, the heading unwrapped.
    phase : ndarray, shape (F,)
        Radians, increasing.
    seconds : ndarray, shape (F,)
        Time since the start of the stretch.
    """

    angles: Array
    phase: Array
    seconds: Array

    @property
    def strides(self) -> float:
        """Number of strides."""
        return float(np.ptp(self.phase) / (2 * np.pi))

    @property
    def cadence(self) -> float:
        """Strides per second."""
        return self.strides / float(np.ptp(self.seconds))

    def part(self, first: float, last: float) -> Steps:
        """Frames whose phase is between two phases, the last one excluded."""
        inside = (self.phase >= first) & (self.phase < last)
        return Steps(self.angles[inside], self.phase[inside], self.seconds[inside])


def ankle_lead(angles: Array) -> Array:
    """Distance of the left ankle in front of the right one, along the heading.

    Parameters
    ----------
    angles : ndarray, shape (F, 54)
        Degrees.

    Returns
    -------
    lead : ndarray, shape (F,)
        Metres.
    """
    facing_z = angles.copy()
    facing_z[:, 0] = 0.0
    points, _ = skeleton.forward_kinematics(skeleton.rotations_from_angles(facing_z))
    left, right = (skeleton.POINTS.index(f"{side}_ankle") for side in ("left", "right"))
    return points[:, left, 2] - points[:, right, 2]


def steady_steps(motion: Motion) -> list[Steps]:
    """Find the stretches of a take in which the person walks.

    Parameters
    ----------
    motion : Motion
        At 12 frames per second or more.

    Returns
    -------
    stretches : list of Steps
        Each from one passing of the ankles to another, of at least one stride.
    """
    frames_per_second = motion.frames_per_second
    if len(motion) < frames_per_second:
        return []
    lead = ankle_lead(motion.angles)
    low_pass = butter(2, 3.0, fs=frames_per_second, output="sos")
    smooth = sosfiltfilt(low_pass, lead, padlen=min(len(lead) - 1, int(frames_per_second)))
    before = np.flatnonzero(np.signbit(smooth[:-1]) != np.signbit(smooth[1:]))
    passing = before + smooth[before] / (smooth[before] - smooth[before + 1])
    good = [
        STEP_SECONDS[0] <= (end - start) / frames_per_second <= STEP_SECONDS[1]
        and np.abs(smooth[int(start) : int(end) + 2]).max() >= STEP_LENGTH
        for start, end in pairwise(passing)
    ]
    stretches = []
    first = 0
    for k in range(len(good) + 1):
        if k == len(good) or not good[k]:
            if k - first >= 2:
                forward = bool(smooth[before[first]] < 0)
                stretches.append(_stretch(motion, passing[first : k + 1], forward))
            first = k + 1
    return stretches


def _stretch(motion: Motion, passing: Array, forward: bool) -> Steps:
    """Interpolate the phase between the frames, as fractions, at which the ankles pass."""
    frames = np.arange(int(np.ceil(passing[0])), int(passing[-1]) + 1)
    marks = np.pi * (np.arange(len(passing)) + (0 if forward else 1))
    angles = motion.angles[frames].copy()
    angles[:, 0] = np.rad2deg(np.unwrap(np.deg2rad(angles[:, 0])))
    return Steps(
        angles, np.interp(frames, passing, marks), (frames - frames[0]) / motion.frames_per_second
    )


def harmonics_basis(phase: Array) -> Array:
    """Cosines and sines of the first two harmonics, shape (F, 2, 2)."""
    multiples = np.asarray(phase)[:, None] * np.array([1.0, 2.0])
    return np.stack([np.cos(multiples), np.sin(multiples)], axis=-1)


def fit_harmonics(steps: Steps) -> tuple[Array, Array]:
    """Fit the first two harmonics of the phase to the angles by least squares.

    Parameters
    ----------
    steps : Steps

    Returns
    -------
    mean : ndarray, shape (54,)
        Degrees; 0 for the heading, whose oscillation about the direction of travel alone is
        kept. That direction is fitted as a parabola of time.
    harmonics : ndarray, shape (2, 2, 54)
        Degrees; the axes are harmonic, cosine and sine, angle.
    """
    waves = harmonics_basis(steps.phase).reshape(-1, 4)
    ones = np.ones((len(waves), 1))
    time = steps.seconds[:, None] - steps.seconds.mean()
    posture = np.linalg.lstsq(np.hstack([waves, ones]), steps.angles, rcond=None)[0]
    heading = np.linalg.lstsq(
        np.hstack([waves, ones, time, time**2]), steps.angles[:, 0], rcond=None
    )[0]
    mean, harmonics = posture[4].astype(np.float64), posture[:4].astype(np.float64)
    mean[0], harmonics[:, 0] = 0.0, heading[:4]
    return mean, harmonics.reshape(2, 2, -1)


def mirrored_gait(mean: Array, harmonics: Array) -> tuple[Array, Array]:
    """Swap left and right: the mirrored walk, half a stride later.

    Parameters
    ----------
    mean : ndarray, shape (54,)
    harmonics : ndarray, shape (2, 2, 54)

    Returns
    -------
    mean : ndarray, shape (54,)
    harmonics : ndarray, shape (2, 2, 54)
    """
    partner = [_other_side(name) for name in skeleton.ANGLES]
    sign = np.array([1.0 if name.endswith("_x") else -1.0 for name in skeleton.ANGLES])
    half_a_stride_later = np.array([-1.0, 1.0])[:, None, None]
    return (mean * sign)[partner], (harmonics * sign * half_a_stride_later)[..., partner]


def _other_side(angle: str) -> int:
    side, _, rest = angle.partition("_")
    other = {"left": "right", "right": "left"}.get(side, side)
    return skeleton.ANGLES.index(f"{other}_{rest}")
