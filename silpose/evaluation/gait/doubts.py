"""What does not fit together: a path and the feet that should have walked it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from silpose.evaluation.gait.stretch import (
    DIRECTION_HZ,
    RATE,
    Stretch,
    low_pass,
    path_of_feet,
)

_SLOW = 0.2  # m/s below which feet do not walk
_WAYS = (0.5, 2.0)  # a path over what the feet walked
_ANGLE = 45.0  # degrees between them
_RISE = 0.5  # metres


def doubts_of_path(parts: Sequence[Stretch]) -> list[str]:
    """Compare a path that was given with the way of the feet.

    Parameters
    ----------
    parts : sequence of Stretch

    Returns
    -------
    notes : list of str
        A sentence for each doubt.
    """
    if not parts:
        return []
    notes = []
    heights = np.concatenate([part.path[:, 1] for part in parts])
    rise = float(np.ptp(np.percentile(heights, (5, 95))))
    if rise > _RISE:
        notes.append(f"The path rises and falls by {rise:.1f} m: is +Y up?")
    given, walked = (
        np.concatenate(
            [low_pass(np.gradient(path, 1 / RATE, axis=0), DIRECTION_HZ)[:, [0, 2]]
             for path in paths]
        )
        for paths in ([part.path for part in parts], [path_of_feet(p.points) for p in parts])
    )  # fmt: skip
    speeds = [np.linalg.norm(velocity, axis=1) for velocity in (given, walked)]
    moving = speeds[1] > _SLOW
    if moving.sum() < RATE:
        return notes
    ratio = float(np.median(speeds[0][moving]) / np.median(speeds[1][moving]))
    if not _WAYS[0] <= ratio <= _WAYS[1]:
        notes.append(
            f"The path is {ratio:.2g} times as long as the way that the feet walk: is it in "
            "metres? On a treadmill, leave the path out."
        )
    if ratio > _WAYS[0]:
        cross = given[:, 1] * walked[:, 0] - given[:, 0] * walked[:, 1]
        apart = np.rad2deg(np.arctan2(cross, np.sum(given * walked, axis=1)))[moving]
        if np.median(np.abs(apart)) > _ANGLE:
            notes.append(
                f"The path goes {np.median(np.abs(apart)):.0f} degrees off the way that the feet "
                "walk: headings must be in its world; camera_azimuth turns them into it."
            )
    return notes
