"""AMASS files, and others of SMPL poses: their rest is the project's zero pose."""

from __future__ import annotations

import zipfile
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from silpose.core.errors import InputError
from silpose.core.skeleton import OFFSETS, SPINE_OFFSETS
from silpose.core.types import Array
from silpose.motion.capture.formats.archive import Archive
from silpose.motion.capture.raw_motion import LARGEST_SIZE, RawMotion, world_from_local

# The first 22 joints of SMPL, SMPL-H and SMPL-X: name, parent, and the joint or tip of this
# project's skeleton at that place. The three joints of the spine together are the chest.
_SMPL: tuple[tuple[str, int, str], ...] = (
    ("pelvis", -1, "root"), ("left_hip", 0, "left_hip"), ("right_hip", 0, "right_hip"),
    ("spine1", 0, ""), ("left_knee", 1, "left_knee"), ("right_knee", 2, "right_knee"),
    ("spine2", 3, ""), ("left_ankle", 4, "left_ankle"), ("right_ankle", 5, "right_ankle"),
    ("spine3", 6, ""), ("left_foot", 7, "left_toes"), ("right_foot", 8, "right_toes"),
    ("neck", 9, "neck"), ("left_collar", 9, "left_collar"), ("right_collar", 9, "right_collar"),
    ("head", 12, "head"), ("left_shoulder", 13, "left_shoulder"),
    ("right_shoulder", 14, "right_shoulder"), ("left_elbow", 16, "left_elbow"),
    ("right_elbow", 17, "right_elbow"), ("left_wrist", 18, "left_wrist"),
    ("right_wrist", 19, "right_wrist"),
)  # fmt: skip
_ENDS = ((15, "head_top"), (20, "left_hand"), (21, "right_hand"))

_POSES = ("poses", "smpl_poses", "fullpose", "pose")
_ROOT = ("root_orient", "global_orient", "smpl_root_orient")
_BODY = ("pose_body", "body_pose", "smpl_body_pose")
_PLACE = ("trans", "transl", "smpl_trans", "translation")
_RATE = ("mocap_framerate", "mocap_frame_rate", "framerate", "frame_rate", "fps")

LARGEST_TURN, LARGEST_STEP = 4 * np.pi, 1e4
"""Largest length of an axis-angle, radians, and largest position, metres."""

_OTHER_ROTATIONS = {
    4: "quaternions (x, y, z, w), by Rotation.from_quat",
    6: "two columns of matrices, by Rotation.from_matrix, the third column being their np.cross",
    9: "matrices, by Rotation.from_matrix",
}
_UNIT = 1e-2  # by which the length of what is read as a unit vector differs from 1

_MOTION_KEYS = (*_POSES, *_ROOT, *_BODY, *_PLACE)


def read_amass(file: str | Path, frame_rate: float | None = None) -> RawMotion:
    """Read an AMASS file.

    Parameters
    ----------
    file : str or Path
        An ``.npz`` that holds ``poses`` (axis-angle, radians) of shape (F, C) or (F, C / 3, 3), C
        from 66; or ``root_orient`` (F, 3) and ``pose_body`` (F, 63 or more); ``trans`` (F, 3); and
        ``mocap_framerate``, ``mocap_frame_rate`` or ``fps``. Nothing pickled is read.
    frame_rate : float or None, default=None
        Frames per second in place of the file's.

    Returns
    -------
    motion : RawMotion
        SMPL's 22 joints of body and head by its names, and their ends, with this project's offsets.

    Raises
    ------
    InputError
        If a key is missing or holds something else; the message names it.
    """
    file = Path(file)
    with Archive(file) as archive:
        turns, notes = _turns(archive)
        place = _place(archive, len(turns))
        rate = frame_rate if frame_rate is not None else _rate(archive)
    count = len(turns)
    if count * len(_SMPL) > LARGEST_SIZE:
        raise InputError(
            f"{file}: has {count} frames, more than fit into memory; split it into shorter takes"
        )
    names = (*(name for name, _, _ in _SMPL), *(f"{_SMPL[j][0]}/end" for j, _ in _ENDS))
    parents = (*(parent for _, parent, _ in _SMPL), *(j for j, _ in _ENDS))
    offsets = _offsets()
    rotations = np.tile(np.eye(3), (count, len(names), 1, 1))
    flat = Rotation.from_rotvec(turns.reshape(-1, 3)).as_matrix()
    rotations[:, : len(_SMPL)] = flat.reshape(count, len(_SMPL), 3, 3)
    positions = np.tile(offsets, (count, 1, 1))
    positions[:, 0] = place
    rotations, positions = world_from_local(parents, rotations, positions)
    return RawMotion(
        file=str(file),
        names=names,
        parents=parents,
        offsets=offsets,
        rotations=rotations,
        positions=positions,
        frames_per_second=rate,
        up="z",
        unit=1.0,
        format="AMASS",
        notes=notes,
    )


def holds_motion(file: Path) -> bool:
    """Whether an archive has any key of motion; a file that is no archive may be a damaged one.

    AMASS's folders hold ``shape.npz`` and ``…_stagei.npz`` beside the poses, which have none.
    """
    try:
        with zipfile.ZipFile(file) as archive:
            keys = {name.removesuffix(".npy") for name in archive.namelist()}
    except (zipfile.BadZipFile, OSError, ValueError, NotImplementedError):
        return True
    return not keys.isdisjoint(_MOTION_KEYS)


def _offsets() -> Array:
    spine = iter(SPINE_OFFSETS)
    joints = [OFFSETS.get(ours, (0.0, 0.0, 0.0)) if ours else next(spine) for _, _, ours in _SMPL]
    return np.array([*joints, *(OFFSETS[tip] for _, tip in _ENDS)])


def _turns(archive: Archive) -> tuple[Array, tuple[str, ...]]:
    """Axis-angles of the 22 joints, shape (F, 22, 3), radians."""
    columns = 3 * len(_SMPL)
    body, root = archive.first(_BODY), archive.first(_ROOT)
    if (key := archive.first(_POSES)) is None and body and root:
        key = body
        parts = [archive.numbers(name) for name in (root, body)]
        empty = any(part.ndim == 0 or not len(part) for part in parts)
        if empty or len(parts[0]) != len(parts[1]) or parts[0].size != 3 * len(parts[0]):
            raise archive.refuse(
                f"'{root}' has shape {parts[0].shape} and '{body}' {parts[1].shape}; expected "
                "(frames, 3) and (frames, 63)"
            )
        values = np.concatenate([part.reshape(len(part), -1) for part in parts], axis=1)
    elif key is None:
        raise archive.lacks(_POSES[:1], "axis-angles of SMPL's joints")
    else:
        values = archive.numbers(key)
    if size := _other_rotations(values):
        joints = values.size // (len(values) * size)
        raise archive.refuse(
            f"'{key}' of shape {values.shape} holds no axis-angles: convert them from "
            f"{_OTHER_ROTATIONS[size]} of SciPy and its as_rotvec, to shape ({len(values)}, "
            f"{joints}, 3)"
        )
    shape = values.shape
    flat = values
    if values.ndim == 3 and shape[-1] == 3:
        flat = values.reshape(len(values), 3 * shape[1])  # of no frames, too
    if flat.ndim != 2 or flat.shape[1] < columns or flat.shape[1] % 3 or not len(flat):
        raise archive.refuse(
            f"'{key}' has shape {shape}; expected (frames, 156) of SMPL-H, (frames, 165) of SMPL-X "
            "or (frames, 52, 3)"
        )
    turns = flat[:, :columns].reshape(len(flat), len(_SMPL), 3)
    bad = ~np.isfinite(turns).all(axis=(1, 2)) | (np.abs(turns) > 1e4).any(axis=(1, 2))
    if bad.any():
        raise archive.refuse(f"'{key}' is not finite or huge in frame {int(np.argmax(bad))}")
    largest = np.linalg.norm(turns, axis=2).max()
    if largest <= LARGEST_TURN:
        return turns, ()
    note = f"'{key}' holds turns up to {largest:.0f}, which are read as degrees, not radians"
    if largest > 720:
        raise archive.refuse(f"'{key}' holds turns up to {largest:.0f}; expected radians")
    return np.deg2rad(turns), (note,)


def _other_rotations(values: Array) -> int | None:
    """How many numbers a rotation has, if these are quaternions or columns of matrices."""
    each = values[0].size if values.ndim > 1 and len(values) else 0
    if each and each % 4 == 0 and _are_units(values.reshape(-1, 4)):
        return 4
    if each and each % 3 == 0 and _are_units(vectors := values.reshape(-1, 3)):
        if each % 9:
            return 6
        first, second, third = (vectors[k::3] for k in range(3))
        return 9 if np.abs(np.cross(first, second) - third).max() < _UNIT else 6
    interleaved = each and each % 6 == 0
    return 6 if interleaved and _are_units(values.reshape(-1, 3, 2).swapaxes(1, 2)) else None


def _are_units(vectors: Array) -> bool:
    return bool((np.abs(np.linalg.norm(vectors, axis=-1) - 1) < _UNIT).all())


def _place(archive: Archive, count: int) -> Array:
    key = archive.first(_PLACE)
    if key is None:
        raise archive.lacks(
            _PLACE[:1],
            f"positions of the root in metres, shape ({count}, 3); zeros if the person stays",
        )
    place = archive.numbers(key)
    if place.shape == (count, 1, 3):
        place = place[:, 0]
    if place.shape != (count, 3):
        raise archive.refuse(f"'{key}' has shape {place.shape}, not ({count}, 3)")
    bad = ~(np.abs(place) < LARGEST_STEP).all(axis=1)
    if bad.any():
        raise archive.refuse(f"'{key}' is not finite or huge in frame {int(np.argmax(bad))}")
    return place


def _rate(archive: Archive) -> float:
    key = archive.first(_RATE)
    if key is None:
        raise archive.lacks(
            _RATE[:2], "frames per second, which motion.frame_rate=120 gives as well"
        )
    rate = archive.numbers(key)
    if rate.size != 1 or not 1 <= rate.item() <= 10_000:
        raise archive.refuse(
            f"'{key}' is {_shortened(rate)}; expected 1 to 10000 frames per second; "
            "motion.frame_rate=120 gives it as well"
        )
    return float(rate.item())


def _shortened(values: Array) -> str:
    return str(values.item()) if values.size == 1 else f"of shape {values.shape}"
