"""Stretches of uninterrupted poses, on a fine grid of times, without jitter."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.signal import butter, sosfiltfilt

from silpose.core.types import Array, Indices
from silpose.evaluation.gait.walk import SIDES, Walk

RATE = 100.0
"""Samples per second of a stretch."""

LONGEST_GAP = 0.21
"""Longest time without a pose that is bridged, seconds: two frames lost at 15 per second."""

SHORTEST = 1.0
"""Shortest stretch that can hold a stride, seconds."""

DIRECTION_HZ = 0.7
"""Highest frequency of a change of direction: the twist of the pelvis at each step is faster."""

_MOVEMENT_HZ = 6.0  # walking has little above it (Winter, 2009)
_CONTACT = 0.01  # metres by which a sole's point must be lower to bear the weight alone
_SLIP = 0.1  # m/s by which a foot must be slower than the other to stand alone


@dataclass(frozen=True)
class Stretch:
    """Poses without a gap, of N samples.

    Attributes
    ----------
    time : ndarray, shape (N,)
        Seconds.
    points : dict of str to ndarray, shape (N, 3)
        As in `Walk`, metres, relative to the root.
    trunk : ndarray, shape (N, 3)
    path : ndarray, shape (N, 3)
        Places of the root, metres; from the foot that stands where `Walk` has none.
    heading : ndarray, shape (N,)
        Azimuth of where the person faces, degrees, unwrapped, without the pelvis's twist.
    """

    time: Array
    points: dict[str, Array]
    trunk: Array
    path: Array
    heading: Array

    @property
    def forwards(self) -> Array:
        """Direction in which the person faces, shape (N, 3), horizontal."""
        azimuth = np.deg2rad(self.heading)
        return np.stack([np.sin(azimuth), np.zeros_like(azimuth), np.cos(azimuth)], axis=1)

    @property
    def pace(self) -> Array:
        """Speed along the direction that the person faces, m/s, shape (N,); backwards negative."""
        velocity = np.gradient(self.path, 1 / RATE, axis=0)
        return low_pass(np.sum(velocity * self.forwards, axis=1), DIRECTION_HZ)

    def lead(self, point: str) -> Array:
        """How far a point is in front of the hips, metres, shape (N,)."""
        middle = (self.points["left_hip"] + self.points["right_hip"]) / 2
        return np.sum((self.points[point] - middle) * self.forwards, axis=1)

    def place(self, point: str, start: float, end: float) -> Array:
        """Where a point is in the world between two times, metres, shape (3,): the median."""
        first = min(int(np.searchsorted(self.time, start)), len(self.time) - 1)
        last = max(int(np.searchsorted(self.time, end)), first + 1)
        return np.median((self.points[point] + self.path)[first:last], axis=0)


def stretches(walk: Walk) -> list[Stretch]:
    """Cut poses at gaps and put each stretch on a grid of 100 samples a second.

    Splines of the third order pass between the frames, and a filter of zero delay takes out what is
    faster than walking.

    Parameters
    ----------
    walk : Walk

    Returns
    -------
    stretches : list of Stretch
        Those of a second or more.
    """
    known = np.flatnonzero(walk.known)
    cuts = np.flatnonzero(np.diff(walk.time[known]) > LONGEST_GAP) + 1
    parts = np.split(known, cuts)
    return [
        _stretch(walk, part)
        for part in parts
        if len(part) > 3 and np.ptp(walk.time[part]) >= SHORTEST
    ]


def _stretch(walk: Walk, frames: Indices) -> Stretch:
    seconds = walk.time[frames]
    grid = np.arange(seconds[0], seconds[-1] + 1e-9, 1 / RATE)
    grid = np.minimum(grid, seconds[-1])

    def fine(values: Array) -> Array:
        return low_pass(CubicSpline(seconds, values[frames])(grid), _MOVEMENT_HZ)

    points = {name: fine(values) for name, values in walk.points.items()}
    line = points["left_hip"] - points["right_hip"]
    azimuth = np.rad2deg(np.unwrap(np.arctan2(-line[:, 2], line[:, 0])))
    path = path_of_feet(points) if walk.path is None else fine(walk.path)
    return Stretch(grid, points, fine(walk.trunk), path, low_pass(azimuth, DIRECTION_HZ))


def path_of_feet(points: dict[str, Array]) -> Array:
    """Move the root so that the foot that stands stays where it is.

    The lower foot tells roughly where the root goes. The foot that stands is then the one against
    which the root goes fastest that way, as a foot that swings overtakes the root.
    """
    soles = np.stack([[points[f"{s}_{end}"] for end in ("heel", "toes")] for s in SIDES])
    velocity = -np.gradient(soles, 1 / RATE, axis=2)  # of the root, if the point does not move
    velocity[..., 1] = 0.0
    low = np.exp(-(soles[..., 1] - soles[..., 1].min(axis=(0, 1))) / _CONTACT)[..., None]
    rough = low_pass((low * velocity).sum(axis=(0, 1)) / low.sum(axis=(0, 1)), DIRECTION_HZ)
    way = rough / np.maximum(np.linalg.norm(rough, axis=1, keepdims=True), 1e-9)
    own = (low + 1e-12) / (low + 1e-12).sum(axis=1, keepdims=True)
    feet = (own * velocity).sum(axis=1)
    along = np.sum(feet * way, axis=2)
    stands = np.exp((along - along.max(axis=0)) / _SLIP)[..., None]
    return np.cumsum((stands * feet).sum(axis=0) / stands.sum(axis=0), axis=0) / RATE


def low_pass(values: Array, hertz: float) -> Array:
    """Take out what is faster, without delay."""
    filtered = butter(2, hertz, fs=RATE, output="sos")
    reach = min(len(values) - 1, int(RATE / hertz))
    return np.asarray(sosfiltfilt(filtered, values, axis=0, padlen=reach))
