"""Whether a person can move so: speed, strides, units and proportions of a take.

What cannot be is named with its likely cause, such as a wrong frame time.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from silpose.core.skeleton import LIMBS, OFFSETS
from silpose.core.types import Array
from silpose.motion.capture.source_motion import SourceMotion

FASTEST_RUN, FASTEST_EVER = 6.0, 12.0
"""Median speeds that are doubted, and that nobody reaches, metres per second."""

STEP = 0.4
"""Smallest distance between the ankles, from behind to ahead, of somebody who walks, legs."""

SHORTEST_LEG, LONGEST_LEG = 0.5, 1.3
"""Lengths of legs, metres, where the unit is known."""

LEAP, LONGEST_STEP = 15.0, 0.25
"""Speed, metres a second, and way between two frames, metres, that are no movement."""

STILL, FEWEST = 0.001, 10
"""Largest way of any joint of somebody who does not move, metres, in at least so many frames."""

USUAL_RATES = (15, 20, 24, 25, 30, 48, 50, 60, 90, 100, 120, 240)
USUAL_SPEED, USUAL_STRIDES = 1.3, 0.9  # metres and strides a second

SLOWEST, QUICKEST = 0.4, 1.45
"""Least strides a second of somebody who walks, and most of somebody who walks slowly."""

# Least and largest ratio of two lengths: cartoon figures are within, wrong joints are not.
_PROPORTIONS = {
    "thigh over shank": (("hip", "knee"), ("knee", "ankle"), 0.4, 2.5),
    "upper arm over forearm": (("shoulder", "elbow"), ("elbow", "wrist"), 0.4, 3.0),
    "upper arm over thigh": (("shoulder", "elbow"), ("hip", "knee"), 0.3, 1.3),
}


@dataclass(frozen=True)
class Gait:
    """Speed and strides of a take.

    Attributes
    ----------
    speed : float
        Median horizontal speed of the hips, metres per second.
    strides : float or None
        Strides (two steps) a second; None where nobody walks.
    """

    speed: float
    strides: float | None


def our_leg() -> float:
    """Length of the skeleton's legs, metres."""
    bones = [end for start, end in LIMBS.items() if start.endswith(("hip", "knee"))]
    return float(sum(np.linalg.norm(OFFSETS[end]) for end in bones) / 2)


def measure_gait(motion: SourceMotion, frames_per_second: float) -> Gait:
    """Measure speed and strides.

    Parameters
    ----------
    motion : SourceMotion
        Upright, in metres.
    frames_per_second : float
    """
    if len(motion) < 2:
        return Gait(0.0, None)
    # Velocity over a tenth of a second, as markers jitter.
    span = min(max(1, round(frames_per_second / 10)), len(motion) - 1)
    hips = motion.middle("hip")[:, [0, 2]]
    moved = np.linalg.norm(hips[span:] - hips[:-span], axis=1)
    return Gait(
        float(np.median(moved) * frames_per_second / span), _strides(motion, frames_per_second)
    )


def _strides(motion: SourceMotion, frames_per_second: float) -> float | None:
    ahead = motion.facing()[:, :, 2]
    step = motion.positions["left_ankle"] - motion.positions["right_ankle"]
    step = np.sum(step * ahead, axis=1) / motion.leg_length()
    if np.quantile(step, 0.95) - np.quantile(step, 0.05) < STEP:
        return None
    apart = np.flatnonzero(np.abs(step) > STEP / 4)
    changes = apart[1:][np.diff(np.sign(step[apart])) != 0]
    if len(changes) < 2:
        return None
    return float((len(changes) - 1) / 2 * frames_per_second / (changes[-1] - changes[0]))


def doubts_of_gait(gait: Gait, frame_rate: float) -> list[str]:
    """Doubt a frame rate, or a unit, by the speed that it gives; one sentence."""
    strides = f" and takes {gait.strides:.1f} strides" if gait.strides else ""
    what = f"the person moves {gait.speed:.1f} m{strides} a second"
    remedy = f"motion.frame_rate={_likely_rate(gait, frame_rate)} overrides it"
    # A walk at 1.3 m/s has 0.9 strides a second, a run at 6 m/s has 1.7.
    quick = (gait.strides or 0.0) > QUICKEST + 0.15 * gait.speed
    slow = gait.strides is not None and gait.strides < SLOWEST
    if gait.speed > FASTEST_EVER and not quick:
        return [
            f"{what}: are its positions in the unit of its bones, and is the frame time right? "
            f"{remedy}"
        ]
    if gait.speed > FASTEST_RUN or quick or slow:
        return [
            f"{what}, {'slower' if slow else 'faster'} than people do: is the frame time right? "
            f"{remedy}"
        ]
    return []


def _likely_rate(gait: Gait, frame_rate: float) -> int:
    likely = frame_rate * USUAL_STRIDES / (gait.strides or max(gait.speed, 1e-3) / USUAL_SPEED)
    return min(USUAL_RATES, key=lambda rate: abs(np.log(rate / likely)))


def doubts_of_jumps(motion: SourceMotion, frames_per_second: float, first: int) -> list[str]:
    """Doubt a way that jumps, one sentence.

    Parameters
    ----------
    motion : SourceMotion
        Upright, in metres.
    frames_per_second : float
    first : int
        Number of the first frame in the file.
    """
    step = np.linalg.norm(np.diff(motion.middle("hip"), axis=0), axis=1)
    jumps = np.flatnonzero((step * frames_per_second > LEAP) & (step > LONGEST_STEP))
    if not len(jumps):
        return []
    return [
        f"the person jumps {step[jumps[0]]:.1f} m to frame {first + jumps[0] + 1}"
        f"{f', and {len(jumps) - 1} times more' if len(jumps) > 1 else ''}: are there several "
        "takes in one file?"
    ]


def doubts_of_stillness(motion: SourceMotion) -> list[str]:
    """Doubt a take in which nobody moves, one sentence; the motion is in metres."""
    moved = max(float(np.ptp(place, axis=0).max()) for place in motion.positions.values())
    if len(motion) < FEWEST or moved > STILL:
        return []
    return [f"the person holds still in all of its {len(motion)} frames: is its motion missing?"]


def doubts_of_build(motion: SourceMotion, unit: float | None) -> list[str]:
    """Doubts about lengths of limbs, one sentence each.

    Parameters
    ----------
    motion : SourceMotion
        In the file's unit.
    unit : float or None
        Metres per unit, if it is known.
    """
    doubts = []
    leg = motion.leg_length()
    if unit is not None and not SHORTEST_LEG <= unit * leg <= LONGEST_LEG:
        doubts.append(
            f"its legs are {unit * leg:.3g} m long by the unit it gives: lengths are scaled to the "
            "skeleton's legs"
        )
    for what, (one, other, least, largest) in _PROPORTIONS.items():
        ratio = _length(motion, *one) / max(_length(motion, *other), 1e-9)
        if not least <= ratio <= largest:
            doubts.append(
                f"{what} is {ratio:.2g}, people have {least} to {largest}: are its joints matched "
                "rightly? 'silpose motion FILE' shows them, motion.joints={left_elbow: [NAME]} "
                "names others"
            )
    return doubts


def _length(motion: SourceMotion, start: str, end: str) -> float:
    bones: list[Array] = [
        motion.positions[f"{side}_{end}"] - motion.positions[f"{side}_{start}"]
        for side in ("left", "right")
    ]
    return float(np.median(np.linalg.norm(bones, axis=-1)))
