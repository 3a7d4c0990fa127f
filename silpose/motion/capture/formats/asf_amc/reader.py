"""AMC files with their ASF, CMU's native form, as a tree of joints."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.motion.capture.formats.asf_amc.frames import read_frames
from silpose.motion.capture.formats.asf_amc.pairing import find_skeleton
from silpose.motion.capture.formats.asf_amc.skeleton import Bone, read_skeleton
from silpose.motion.capture.raw_motion import LARGEST_SIZE, RawMotion, world_from_local

CMU_LENGTH, INCH = 0.45, 0.0254
"""CMU's files state the unit 0.45: their lengths are inches over 0.45. Metres per inch."""

USUAL_RATE = 120.0
"""Frames per second of AMC files that do not say it, as CMU's."""


def read_asf_amc(file: str | Path, frame_rate: float | None = None) -> RawMotion:
    """Read an AMC file with its skeleton.

    Each bone becomes a joint at the bone's start, with the bone's rotation from the rest pose; a
    bone without children has its end as end site.

    Parameters
    ----------
    file : str or Path
        The AMC; its ASF is found by `find_skeleton`.
    frame_rate : float or None, default=None
        Frames per second, which most AMC files do not say; None: what it says, or 120.

    Returns
    -------
    motion : RawMotion

    Raises
    ------
    InputError
        If either file is damaged, or the skeleton is missing; the message names file and line.
    """
    file = Path(file)
    asf, notes = find_skeleton(file)
    skeleton = read_skeleton(asf)
    frames = read_frames(file, skeleton, asf)
    degrees = skeleton.degrees if frames.degrees is None else frames.degrees
    bones = list(skeleton.bones.values())
    count = len(next(iter(frames.values.values())))
    if count * 2 * len(bones) > LARGEST_SIZE:
        raise InputError(
            f"{file}: has {count} frames of {len(bones)} bones, more than fit into memory; split "
            "it into shorter takes"
        )
    names, parents, offsets = _tree(bones)
    rotations = np.tile(np.eye(3), (count, len(names), 1, 1))
    positions = np.tile(offsets, (count, 1, 1))
    for j, bone in enumerate(bones):
        if bone.moves:
            turned, moved = _moved(bone, frames.values[bone.name], degrees)
            rotations[:, j] = turned
            positions[:, j] += moved
    rotations, positions = world_from_local(parents, rotations, positions)
    rate = frame_rate or frames.frames_per_second
    if rate is None:
        notes = (
            *notes,
            f"an AMC holds no frame rate: {USUAL_RATE:g} per second are assumed, as at "
            f"CMU; if not so, give motion.frame_rate={USUAL_RATE / 2:g}",
        )
    elif not 1 <= rate <= 10_000:
        raise InputError(f"{file}: has {rate:g} frames per second; give motion.frame_rate=120")
    return RawMotion(
        file=str(file),
        names=names,
        parents=parents,
        offsets=offsets,
        rotations=rotations,
        positions=positions,
        frames_per_second=float(rate or USUAL_RATE),
        unit=INCH / CMU_LENGTH if skeleton.length == CMU_LENGTH else None,
        format="ASF/AMC",
        notes=(*notes, *frames.notes),
    )


def _tree(bones: list[Bone]) -> tuple[tuple[str, ...], tuple[int, ...], Array]:
    place = {bone.name: j for j, bone in enumerate(bones)}
    names = [bone.name for bone in bones]
    parents = [-1 if bone.parent is None else place[bone.parent] for bone in bones]
    offsets = [np.zeros(3) if p < 0 else bones[p].vector for p in parents]
    for j, bone in enumerate(bones):
        if j not in parents[: len(bones)] and bone.vector.any():
            names.append(f"{bone.name}/end")
            parents.append(j)
            offsets.append(bone.vector)
    return tuple(names), tuple(parents), np.array(offsets)


def _moved(bone: Bone, values: Array, degrees: bool) -> tuple[Array, Array]:
    """Rotation and shift of a bone in the axes of the rest pose."""
    turned, moved = Rotation.identity(len(values)), np.zeros((len(values), 3))
    for move, column in zip(bone.moves, values.T, strict=True):
        if move.startswith("r"):  # about fixed axes, the first named first
            turned = Rotation.from_euler(move[1], column[:, None], degrees=degrees) * turned
        elif move.startswith("t"):
            moved[:, "xyz".index(move[1])] = column
    axes = Rotation.from_matrix(bone.axes)
    return (axes * turned * axes.inv()).as_matrix(), moved
