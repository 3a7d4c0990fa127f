"""BVH files, read with every defect named."""

from __future__ import annotations

import re
import shutil
import tempfile
import warnings
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pybvh

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.motion.capture.joint_names import Names, match_joints
from silpose.motion.capture.rest_pose import find_rest
from silpose.motion.capture.retarget import retarget
from silpose.motion.capture.source_motion import SourceMotion

LARGEST = 1e6
"""Larger numbers, in degrees or units of length, are damage."""

SHORTEST = 1e-6
"""Shortest leg, in the file's unit."""

SLOWEST, FASTEST = 1.0, 10_000.0
"""Range of plausible frame rates, frames per second."""


def bvh_take(file: Path, frames_per_second: float, names: Names) -> tuple[Array, Array]:
    """Read a BVH file and put its motion on the project's skeleton.

    Parameters
    ----------
    file : Path
        With +Y up.
    frames_per_second : float
        Frame rate of the result; rotations are interpolated on the sphere.
    names : mapping of str to sequence of str
        For each joint of the skeleton the names it may have.

    Returns
    -------
    angles : ndarray, shape (F, 54)
        Degrees.
    root_position : ndarray, shape (F, 3)
        Metres.

    Raises
    ------
    InputError
        If the file is damaged, or its skeleton cannot be used.
    """
    bvh = read_bvh(file)
    joints = bvh_joints(bvh, names, str(file))
    zero = bvh[:1]
    zero.joint_angles = np.zeros_like(zero.joint_angles)
    whole = source_motion(bvh, joints)
    leg = whole.positions["left_hip"][0] - whole.positions["left_ankle"][0]
    if np.linalg.norm(leg) < SHORTEST:
        raise InputError(f"{file}: its legs have no length; export it with its skeleton's offsets")
    constants, dropped = find_rest(whole, source_motion(zero, joints), str(file))
    resampled = bvh[dropped:].resample(frames_per_second)
    return retarget(source_motion(resampled, joints), constants, frames_per_second)


def bvh_joints(bvh: pybvh.Bvh, names: Names, file: str) -> dict[str, str]:
    """Match the skeleton's joints to a file's joints, or end sites (``NAME/end``)."""
    joints = match_joints(bvh.joint_names, names, file)
    for side in ("left", "right"):
        hand, wrist = f"{side}_hand", joints[f"{side}_wrist"]
        if hand not in joints:
            (first, *_) = [n for n in bvh.nodes if n.parent and n.parent.name == wrist] or [None]
            if first is not None and np.linalg.norm(first.offset) > 0:
                joints[hand] = _name(first)
    return joints


def source_motion(bvh: pybvh.Bvh, joints: Mapping[str, str]) -> SourceMotion:
    """Forward kinematics of a file's frames, by this project's names of joints."""
    _, local = bvh.to_rotmat()
    world: dict[str, Array] = {}
    for j, name in enumerate(bvh.joint_names):
        parent = bvh.nodes[bvh.node_index[name]].parent
        world[name] = local[:, j] if parent is None else world[parent.name] @ local[:, j]
    positions = bvh.node_positions()
    nodes = {_name(node): n for n, node in enumerate(bvh.nodes)}
    return SourceMotion(
        rotations={ours: world[name] for ours, name in joints.items() if not ours.endswith("hand")},
        positions={ours: positions[:, nodes[name]] for ours, name in joints.items()},
    )


def _name(node: pybvh.bvhnode.BvhNode) -> str:
    return f"{node.parent.name}/end" if node.is_end_site() else node.name


def read_bvh(file: str | Path) -> pybvh.Bvh:
    """Read a BVH file and check that its motion can be used.

    Parameters
    ----------
    file : str or Path

    Returns
    -------
    bvh : pybvh.Bvh
        With +Y up.

    Raises
    ------
    InputError
        If it is no BVH file, is truncated, has no frames, no frame time or a number that is
        not finite or not plausible.
    """
    file = Path(file)
    first_line = _check_header(file)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the empty motion has its own message below
        try:
            bvh = _parse(file)
        except (ValueError, IndexError, OSError, RecursionError) as error:
            reason = str(error).splitlines()[0] if str(error) else type(error).__name__
            raise InputError(
                f"{file}: cannot be read as BVH, it may be truncated or damaged ({reason}); "
                "export or download it again"
            ) from error
    names = bvh.joint_names
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise InputError(f"{file}: has two joints '{twice[0]}'; give each a name of its own")
    offsets = np.array([node.offset for node in bvh.nodes])
    bad = ~(np.abs(offsets) < LARGEST).all(axis=1)
    if bad.any():
        joint = bvh.nodes[int(np.argmax(bad))].name
        raise InputError(
            f"{file}: the OFFSET of '{joint}' is not finite or huge; export the file again"
        )
    degrees = np.rad2deg(bvh.joint_angles).reshape(bvh.frame_count, -1)
    for what, values in (("position", bvh.root_pos), ("rotation", degrees)):
        bad = ~(np.abs(values) < LARGEST).all(axis=1)
        if bad.any():
            frame = int(np.argmax(bad))
            raise InputError(
                f"{file}: frame {frame}, line {first_line + frame}, holds a {what} that is not "
                "finite or huge; remove such frames or export the file again"
            )
    return bvh


def _check_header(file: Path) -> int:
    """Check what pybvh does not report clearly; return the number of the first frame's line."""
    try:
        text = file.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise InputError(f"{file}: cannot be read ({error.strerror})") from error
    if "HIERARCHY" not in text or "ROOT" not in text:
        raise InputError(f"{file}: is no BVH file (no HIERARCHY with a ROOT); remove or replace it")
    frames = re.search(r"^\s*Frames:\s*(\S+)", text, re.MULTILINE)
    seconds = re.search(r"^\s*Frame Time:\s*(\S+)", text, re.MULTILINE)
    if frames is None or seconds is None:
        raise InputError(
            f"{file}: has no 'Frames:' or no 'Frame Time:' line, it may be truncated; export or "
            "download it again"
        )
    line = text.count("\n", 0, frames.start(1)) + 1
    if _number(frames[1]) == 0:
        raise InputError(f"{file}: line {line}: has no motion frames; export it with its motion")
    line = text.count("\n", 0, seconds.start(1)) + 1
    if not 1 / FASTEST <= _number(seconds[1]) <= 1 / SLOWEST:
        raise InputError(
            f"{file}: line {line}: its frame time is '{seconds[1]}'; it must be a positive number "
            f"of seconds, {1 / FASTEST:g} to {1 / SLOWEST:g}"
        )
    return line + 1


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return float("nan")


def _parse(file: Path) -> pybvh.Bvh:
    if file.suffix == ".bvh":
        return pybvh.read_bvh_file(file, world_up="+y")
    with tempfile.TemporaryDirectory() as folder:  # pybvh accepts lower-case endings only
        copy = Path(folder) / "take.bvh"
        shutil.copyfile(file, copy)
        return pybvh.read_bvh_file(copy, world_up="+y")
