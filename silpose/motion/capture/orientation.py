"""Which way is up: found from the motion itself, as files do not say it, or say it wrongly."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.motion.capture.options import AXES
from silpose.motion.capture.source_motion import SourceMotion, unit

UPRIGHT = 40.0
"""Largest angle between an upright body, ankles to shoulders, and the vertical, degrees."""

MOSTLY = 0.5
"""Share of upright frames at which the expected axis is right."""

ALWAYS = 0.9
"""Share of upright frames from which another axis may be right."""

FARTHEST = 0.5
"""Shortest path of the hips of a person who walks, in lengths of the leg."""

LEVEL = 0.35
"""Largest share of the vertical in the path of a person who walks, or of the lower foot's height
in the length of the leg."""

SLOPING, TILTED = 6.0, 18.0
"""Slope of the ground, and lean of a person against it, from which the vertical is doubted,
degrees."""

# Rotations that turn an axis up: that of +Z is the usual one, y becomes -z.
_UPRIGHT = {
    "y": np.eye(3),
    "z": np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]]),
    "-z": np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]]),
    "-y": np.diag([1.0, -1.0, -1.0]),
    "x": np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]),
    "-x": np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]]),
}


@dataclass(frozen=True)
class Up:
    """The axis that points up.

    Attributes
    ----------
    axis : str
    upright : float
        Share of the frames in which the person is upright along it.
    notes : tuple of str
        What is doubtful about it.
    """

    axis: str
    upright: float
    notes: tuple[str, ...] = ()


def upright_rotation(axis: str) -> Array:
    """Rotation, shape (3, 3), that turns an axis of a file to +Y."""
    return _UPRIGHT[axis]


def find_up(
    motion: SourceMotion, file: str, format_says: str | None, rest: str | None, wanted: str
) -> Up:
    """Find the axis that points up.

    Parameters
    ----------
    motion : SourceMotion
        In the file's own axes.
    file : str
        Named in errors.
    format_says : str or None
        Axis by the format's definition; None stands for ``y``, which most files have.
    rest : str or None
        Axis along which the file's own rest pose is upright, if it has one.
    wanted : str
        Axis that is taken as it is, or ``auto``.

    Returns
    -------
    up : Up

    Raises
    ------
    InputError
        If the person is not upright along the expected axis, and it is not certain which it is.
    """
    body = unit(motion.middle("shoulder") - motion.middle("ankle"))
    shares = {axis: _upright_share(body, axis) for axis in AXES}
    best = max(AXES, key=lambda axis: shares[axis])
    if wanted != "auto":
        doubt = (
            f"motion.up is {wanted}, but the person is upright along {best} in {shares[best]:.0%} "
            "of the frames"
        )
        doubted = shares[wanted] < MOSTLY <= shares[best]
        return Up(wanted, shares[wanted], (doubt,) if doubted else ())
    expected = format_says or "y"
    if shares[expected] >= MOSTLY:
        doubt = (
            f"the person is upright along {expected} in only {shares[expected]:.0%} of the frames"
        )
        return Up(expected, shares[expected], (doubt,) if shares[expected] < 0.75 else ())
    if shares[best] >= ALWAYS and (_walks(motion, best) or rest == best):
        note = (
            f"{best} points up in it, not {expected}, as the person is upright along {best}: it is "
            f"turned upright (motion.up={expected} takes it as it is)"
        )
        return Up(best, shares[best], (note,))
    if shares[best] >= MOSTLY:
        raise InputError(
            f"{file}: the person is upright along {best}, not along {expected}, and does not walk, "
            f"so that it may lie or stand: give motion.up={best} if {best} points up in the file, "
            f"motion.up={expected} if the person lies"
        )
    raise InputError(
        f"{file}: the person does not stand upright along {expected} nor along any other axis (in "
        f"{shares[best]:.0%} of the frames along {best}): give the axis that points up, such as "
        f"motion.up={expected}"
    )


def doubts_of_level(motion: SourceMotion) -> list[str]:
    """Doubts about a vertical that is tilted, as a camera's may be, one sentence each.

    Parameters
    ----------
    motion : SourceMotion
        Upright.
    """
    feet = np.stack([motion.positions[f"{side}_ankle"] for side in ("left", "right")])
    lower = feet[np.argmin(feet[:, :, 1], axis=0), np.arange(len(motion))]
    place = lower - lower.mean(axis=0)
    along = np.linalg.svd(place[:, [0, 2]], full_matrices=False)[2][0]
    way = place[:, [0, 2]] @ along
    if max(np.ptp(way), np.ptp(place[:, 1])) > 2 * motion.leg_length():
        slope = float(np.degrees(np.arctan(abs(np.sum(way * place[:, 1]) / np.sum(way**2)))))
        if slope > SLOPING:
            return [
                f"the ground slopes by {slope:.0f} degrees: is it a ramp, is the vertical that of "
                "a tilted camera, or are its positions in other axes than its rotations?"
            ]
    body = unit(motion.middle("shoulder") - motion.middle("ankle")).mean(axis=0)
    lean = float(np.degrees(np.arccos(np.clip(unit(body)[1], -1.0, 1.0))))
    if lean > TILTED:
        return [
            f"the person leans by {lean:.0f} degrees on average: is the vertical that of a tilted "
            "camera?"
        ]
    return []


def _upright_share(body: Array, axis: str) -> float:
    along = body @ _vector(axis)
    return float(np.mean(along >= np.cos(np.deg2rad(UPRIGHT))))


def _walks(motion: SourceMotion, axis: str) -> bool:
    """Whether the hips move across an axis while the lower foot stays at its height.

    A person who lies moves neither far nor across the body's length.
    """
    up, leg = _vector(axis), motion.leg_length()
    hips = motion.middle("hip")
    path = np.linalg.norm(hips - hips[0], axis=1).max()
    if path < FARTHEST * leg:
        return False
    rise = np.ptp(hips @ up)
    feet = np.stack([motion.positions[f"{side}_ankle"] @ up for side in ("left", "right")])
    return bool(rise < LEVEL * path and np.ptp(feet.min(axis=0)) < LEVEL * leg)


def _vector(axis: str) -> Array:
    vector = np.zeros(3)
    vector["xyz".index(axis[-1])] = -1.0 if axis.startswith("-") else 1.0
    return vector
