"""Positions in another unit than the bones: found as feet that stand must not slide.

While a foot stands, the hips move as fast as the foot moves backwards beneath them. If they move a
hundred times as fast, positions are in centimetres and bones in metres.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from silpose.motion.capture.source_motion import SourceMotion, unit

STEPPING = 0.3
"""Lowest speed of feet beneath the hips of somebody who walks, legs a second."""

FEWEST = 8
"""Fewest frames of steps from which the ratio is known."""

SLIDING = 2.0
"""Ratio from which, or from whose inverse, feet are said to slide; real walks have 1.0 to 1.1."""

ALIKE = 0.7
"""Smallest cosine between the ways of hips and feet of somebody who does not walk on the spot."""

# How many units of positions are one unit of bones, where files mix two.
_FACTORS = {
    100.0: "centimetres to metres",
    1000.0: "millimetres to metres",
    0.01: "metres to centimetres",
    0.001: "metres to millimetres",
}
_NEAR = np.log(1.25)


@dataclass(frozen=True)
class Pace:
    """Speed of the hips over that with which standing feet move beneath them.

    Attributes
    ----------
    ratio : float
    alike : float
        Median cosine between both directions.
    """

    ratio: float
    alike: float


def pace_of_hips(motion: SourceMotion, frames_per_second: float) -> Pace | None:
    """Compare the speed of the hips to that of the feet beneath them.

    Parameters
    ----------
    motion : SourceMotion
        Upright.
    frames_per_second : float

    Returns
    -------
    pace : Pace or None
        None if nobody walks.
    """
    if len(motion) <= FEWEST:
        return None
    hips = motion.middle("hip")
    feet = np.stack([motion.positions[f"{side}_ankle"] for side in ("left", "right")])
    way = np.diff(hips, axis=0)[:, [0, 2]]
    pushes = -np.diff(feet - hips, axis=1)[:, :, [0, 2]]
    speed = np.linalg.norm(way, axis=1)
    # Of the two feet, the one that stands is the one that moves backwards beneath the hips.
    along = np.sum(pushes * way, axis=2) / np.maximum(speed, 1e-12)
    standing, along = np.argmax(along, axis=0), np.max(along, axis=0)
    push = pushes[standing, np.arange(len(standing))]
    fast = np.quantile(along, 0.9)
    used = (speed > 0) & (along > fast / 4)
    if fast <= STEPPING * motion.leg_length() / frames_per_second or used.sum() < FEWEST:
        return None
    alike = np.sum(unit(push) * unit(way), axis=1)
    return Pace(float(np.median(speed[used] / along[used])), float(np.median(alike[used])))


def same_unit(pace: Pace | None) -> tuple[float, str | None]:
    """Factor that brings positions to the unit of the bones, and a sentence that says so.

    Parameters
    ----------
    pace : Pace or None
        From `pace_of_hips`.

    Returns
    -------
    factor : float
        1 if nothing is to be done.
    note : str or None
    """
    if pace is None:
        return 1.0, None
    units = min(_FACTORS, key=lambda factor: abs(np.log(pace.ratio / factor)))
    if abs(np.log(pace.ratio / units)) < _NEAR and pace.alike > ALIKE:
        return 1 / units, (
            f"its positions are to its bones as {_FACTORS[units]}, as its feet would slide: the "
            f"person's way is {'divided' if units > 1 else 'multiplied'} by "
            f"{max(units, 1 / units):.0f}"
        )
    if pace.ratio > SLIDING or (pace.ratio < 1 / SLIDING and pace.alike > ALIKE):
        return 1.0, f"its feet slide: its hips move {pace.ratio:.2g} times as fast as its feet push"
    return 1.0, None


def moved(motion: SourceMotion, factor: float) -> SourceMotion:
    """Scale the way of the whole person, but not the person."""
    way = (factor - 1.0) * motion.positions["root"]
    return SourceMotion(
        motion.rotations, {joint: place + way for joint, place in motion.positions.items()}
    )
