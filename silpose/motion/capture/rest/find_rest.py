"""The search for a source's rest pose, from the most certain to the least."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.motion.capture.options import AXES
from silpose.motion.capture.orientation import upright_rotation
from silpose.motion.capture.rest.limbs import limb_constants
from silpose.motion.capture.rest.postures import (
    arms_hang,
    constants_of_posture,
    is_ours,
    is_rest_pose,
    is_standing_pose,
    is_t_pose,
)
from silpose.motion.capture.rest.torso import torso_rest
from silpose.motion.capture.source_motion import SourceMotion

T_POSE, N_POSE = 3.0, 6.0
"""By how many degrees the torso of a T-pose or an N-pose may be off."""

JUMP = 0.15
"""Smallest step of an arm's direction between frames that is no movement, as a length."""


@dataclass(frozen=True)
class Rest:
    """Rest pose of a source.

    Attributes
    ----------
    constants : dict of str to ndarray, shape (3, 3)
        C_j of the joints that the source has.
    dropped : int
        Number of frames at the beginning that are the rest pose and not part of the motion.
    how : str
        How it was found.
    uncertainty : float
        By how many degrees the torso may be off.
    exact : bool
        Whether it is the project's own zero pose.
    assumed, notes : tuple of str
        What was concluded, and what is doubtful.
    """

    constants: dict[str, Array]
    dropped: int
    how: str
    uncertainty: float
    exact: bool = False
    assumed: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


def rest_axis(zero: SourceMotion) -> str | None:
    """Axis along which the pose without rotations is an upright rest pose, +Y rather than others.

    Parameters
    ----------
    zero : SourceMotion
        One frame, in the file's own axes.
    """
    for axis in ("y", *(axis for axis in AXES if axis != "y")):
        if is_rest_pose(zero.transformed(upright_rotation(axis)))[0]:
            return axis
    return None


def find_rest(motion: SourceMotion, zero: SourceMotion, file: str) -> Rest:
    """Find every joint's constant C_j.

    Parameters
    ----------
    motion : SourceMotion
        Upright.
    zero : SourceMotion
        One frame in which no joint is rotated; upright if it can be a rest pose.
    file : str
        Named in errors.

    Returns
    -------
    rest : Rest

    Raises
    ------
    InputError
        If there is no motion after the rest pose.
    """
    if is_ours(zero):
        own = {joint: turned[0].T for joint, turned in zero.rotations.items()}
        return Rest(own, 0, "the pose without rotations is the skeleton's own", 0.0, exact=True)
    if (t_pose := _t_pose(motion[:1])) is not None:
        return _from_t_pose(motion, t_pose, file)
    if is_rest_pose(zero)[0]:
        return Rest(constants_of_posture(zero), 0, "the pose without rotations", T_POSE)
    if is_standing_pose(motion[:1])[0]:
        # Arms that hang may belong to the motion; an A-pose that the person leaps out of does not.
        dropped = int(len(motion) > 1 and not arms_hang(motion[:1])[0] and _jumps(motion, 1))
        how = "the first frame stands at attention"
        return Rest(constants_of_posture(motion[:1]), dropped, how, N_POSE, assumed=(how,))
    if (stretched := is_t_pose(motion) & is_rest_pose(motion)).any():
        frame = int(np.argmax(stretched))
        how = f"frame {frame} is a T-pose"
        notes = (f"{how}, which is kept",)
        return Rest(constants_of_posture(motion[frame : frame + 1]), 0, how, T_POSE, notes=notes)
    torso = torso_rest(motion, zero)
    assumed = (
        f"no rest pose in it: {torso.how}; its torso may be {torso.uncertainty:.0f} degrees off"
    )
    return Rest(
        torso.constants | limb_constants(motion), 0, torso.how, torso.uncertainty,
        assumed=(assumed,),
    )  # fmt: skip


def _t_pose(first: SourceMotion) -> SourceMotion | None:
    """Turn the first frame upright, along whatever axis, if it is a T-pose then."""
    for axis in ("y", *(axis for axis in AXES if axis != "y")):
        turned = first.transformed(upright_rotation(axis))
        if is_t_pose(turned)[0] and is_rest_pose(turned)[0]:
            return turned
    return None


def _from_t_pose(motion: SourceMotion, t_pose: SourceMotion, file: str) -> Rest:
    """Rest of a motion that begins with a T-pose, which is left out if it was put before it."""
    stretched = is_t_pose(motion)
    stretched[0] = True
    held = len(motion) if stretched.all() else int(np.argmin(stretched))
    if len(motion) == 1:
        raise InputError(f"{file}: the only frame is the T-pose; export it with its motion")
    how, notes = "the first frame is a T-pose", list[str]()
    if held > 1:
        how = f"the first {held} frames are a T-pose"
        if held < len(motion) and _jumps(motion, held):
            notes.append(f"{how}, which does not belong to the motion: they are left out")
        else:
            if held < len(motion):
                notes.append(f"{how}, from which the person moves on: all but the first are kept")
            held = 1
    constants = constants_of_posture(t_pose)
    return Rest(constants, held, how, T_POSE, assumed=(how,), notes=tuple(notes))


def _jumps(motion: SourceMotion, frame: int) -> bool:
    """Whether an arm jumps to a frame, far more than from the next to the one after."""
    turns = []
    for side in ("left", "right"):
        bone = motion.direction(f"{side}_shoulder", f"{side}_wrist")[frame - 1 : frame + 2]
        step = np.linalg.norm(np.diff(bone, axis=0), axis=1)
        turns.append(step[0] > JUMP and (len(step) < 2 or step[0] > 3 * step[1]))
    return any(turns)
