"""Straight walks past several cameras, as data sets for gait recognition show them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from silpose.core.pose_space import wrap_degrees
from silpose.core.types import Array
from silpose.motion import Motion


def seen_from(motion: Motion, views: Sequence[float], change: float, first: int) -> list[Motion]:
    """Divide a motion among views, and straighten its course in each.

    Parameters
    ----------
    motion : Motion
    views : sequence of float
        Directions of the walk relative to the camera, degrees, as headings are.
    change : float
        Degrees by which a direction increases from the beginning of its part to the end, half of
        them before the view itself.
    first : int
        Index of the view that the first part has; the others follow in turn.

    Returns
    -------
    parts : list of Motion
        Equally long, one for each view; fewer if there are not as many frames. The body still
        turns from step to step, but its course no longer does.
    """
    sway = wrap_degrees(motion.angles[:, 0] - course(motion))
    ends = np.linspace(0, len(motion), len(views) + 1).round().astype(int)
    parts = []
    for k, (start, stop) in enumerate(pairwise(ends)):
        if start == stop:
            continue
        view = views[(first + k) % len(views)]
        part = motion.part(start, stop)
        angles = part.angles.copy()
        passing = np.linspace(-change / 2, change / 2, stop - start) if stop - start > 1 else 0.0
        angles[:, 0] = view + passing + sway[start:stop]
        parts.append(replace(part, name=f"{motion.name}@{view:g}", angles=angles))
    return parts


def course(motion: Motion) -> Array:
    """Direction in which a person goes: the heading without what changes within a second.

    Parameters
    ----------
    motion : Motion

    Returns
    -------
    course : ndarray, shape (F,)
        Degrees, without jumps.
    """
    heading = np.unwrap(motion.angles[:, 0], period=360)
    half = min(round(motion.frames_per_second / 2), len(heading) - 1)
    padded = np.pad(heading, half, mode="reflect", reflect_type="odd")
    return np.convolve(padded, np.full(2 * half + 1, 1 / (2 * half + 1)), mode="valid")
