"""Where the person faces: told by knees and feet, and held against the names left and right.

The hip line, from the right hip to the left, tells where the person faces if left and right are
named rightly and the axes are right-handed. Knees bend forwards and toes are ahead of ankles
whatever the names and axes are. Where both are silent, the direction of travel decides.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from silpose.core.types import Array
from silpose.motion.capture.source_motion import SourceMotion, unit

BENT = 15.0
"""Smallest flexion at which a knee tells where the person faces, degrees."""

CLEAR = 0.8
"""Share of frames that must agree for knees, feet or travel to tell anything."""

FEWEST = 3
"""Fewest bent knees, feet, or frames of travel that tell anything, if there are so many frames."""

FOOT = 0.3
"""Smallest share of the way from ankle to toes across the body that tells anything."""

SPEED = 0.3
"""Lowest speed of the hips that tells where the person faces, lengths of the leg per second."""


@dataclass(frozen=True)
class Facing:
    """What tells whether the person faces where the hip line says.

    Attributes
    ----------
    forwards : dict of str to bool
        For ``knees``, ``feet`` and ``travel``, those that tell anything: whether they agree with
        the hip line.
    """

    forwards: dict[str, bool]

    @property
    def contradictory(self) -> bool:
        """Whether knees and feet tell different things."""
        return len(set(self._cues().values())) == 2

    @property
    def reversed(self) -> bool:
        """Whether left and right are exchanged."""
        return not next(iter(self._cues().values()), True)

    @property
    def known(self) -> bool:
        """Whether knees or feet tell where the person faces."""
        return bool(self._cues())

    @property
    def decided_by(self) -> str:
        """What tells it: knees, if feet disagree with them."""
        return "knees" if self.contradictory else str(self)

    def _cues(self) -> dict[str, bool]:
        return {cue: self.forwards[cue] for cue in ("knees", "feet") if cue in self.forwards}

    def __str__(self) -> str:
        return " and ".join(self._cues()) or "the names left and right"


def find_facing(motion: SourceMotion, frames_per_second: float) -> Facing:
    """Find what knees, feet and travel tell about where the person faces.

    Parameters
    ----------
    motion : SourceMotion
        Upright.
    frames_per_second : float

    Returns
    -------
    facing : Facing
    """
    # Ahead of the body, not of the world, as people may lie or tumble for a while.
    body = unit(motion.middle("shoulder") - motion.middle("ankle"))
    ahead = unit(np.cross(motion.direction("right_hip", "left_hip"), body))
    told = {
        "knees": _told(_knees(motion, ahead), len(motion)),
        "feet": _told(_feet(motion, ahead, body), len(motion)),
        "travel": _told(_travel(motion, frames_per_second), len(motion)),
    }
    return Facing({cue: verdict for cue, verdict in told.items() if verdict is not None})


def _told(along: Array, frames: int) -> bool | None:
    if len(along) < min(FEWEST, 2 * frames):
        return None
    share = float(np.mean(along > 0))
    return True if share >= CLEAR else False if share <= 1 - CLEAR else None


def _knees(motion: SourceMotion, ahead: Array) -> Array:
    """How far bent knees are ahead of the line from hip to ankle."""
    found = []
    for side in ("left", "right"):
        hip, knee, ankle = (motion.positions[f"{side}_{j}"] for j in ("hip", "knee", "ankle"))
        thigh, shank = unit(knee - hip), unit(ankle - knee)
        bent = np.sum(thigh * shank, axis=1) < np.cos(np.deg2rad(BENT))
        found.append(np.sum((thigh - shank) * ahead, axis=1)[bent])
    return np.concatenate(found)


def _feet(motion: SourceMotion, ahead: Array, body: Array) -> Array:
    """How far toes are ahead of ankles, where feet do not point along the body."""
    found = []
    for side in ("left", "right"):
        if f"{side}_toes" in motion.positions:
            foot = motion.direction(f"{side}_ankle", f"{side}_toes")
            flat = np.linalg.norm(np.cross(foot, body), axis=1) > FOOT
            found.append(np.sum(foot * ahead, axis=1)[flat])
    return np.concatenate(found) if found else np.empty(0)


def _travel(motion: SourceMotion, frames_per_second: float) -> Array:
    """How fast the hips move ahead, where they move."""
    ahead = motion.facing()[:, :, 2]
    if len(motion) < 2:
        return np.empty(0)
    velocity = np.gradient(motion.middle("hip"), axis=0) * frames_per_second
    velocity = velocity * [1.0, 0.0, 1.0] / motion.leg_length()
    moving = np.linalg.norm(velocity, axis=1) > SPEED
    return np.sum(velocity * ahead, axis=1)[moving]
