"""AMASS files: poses of SMPL-H or SMPL-X bodies, whose rest is the skeleton's zero pose."""

from __future__ import annotations

import zipfile
import zlib
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation, Slerp

from silpose.core import skeleton
from silpose.core.errors import InputError
from silpose.core.types import Array

# The first 22 joints of SMPL-H and SMPL-X, by this project's names. The three spine joints together
# are the chest; toes are left out.
_SMPL: tuple[str | None, ...] = (
    "root", "left_hip", "right_hip", "chest", "left_knee", "right_knee", "chest",
    "left_ankle", "right_ankle", "chest", None, None,
    "neck", "left_collar", "right_collar", "head",
    "left_shoulder", "right_shoulder", "left_elbow", "right_elbow", "left_wrist", "right_wrist",
)  # fmt: skip

_UPRIGHT = Rotation.from_euler("X", -90, degrees=True)  # AMASS has +Z up
_LARGEST_TURN, _LARGEST_STEP = 100.0, 1e4  # radians, metres: larger numbers are damage
_RATES = ("mocap_framerate", "mocap_frame_rate")


def amass_take(file: Path, frames_per_second: float) -> tuple[Array, Array]:
    """Read an AMASS file.

    Parameters
    ----------
    file : Path
        An ``.npz`` that holds ``poses`` (F, 156 or 165; axis-angle, radians), ``trans`` (F, 3;
        metres, +Z up) and ``mocap_framerate`` or ``mocap_frame_rate``. Nothing pickled is read.
    frames_per_second : float
        Frame rate of the result; rotations are interpolated on the sphere.

    Returns
    -------
    angles : ndarray, shape (F, 54)
        Degrees.
    root_position : ndarray, shape (F, 3)
        Metres; lowered or raised so that the soles stand on the ground in the median frame.
    """
    poses, trans, rate = _arrays(file)
    time = np.arange(len(poses)) / rate
    wanted = np.arange(0.0, time[-1] + 1e-9, 1 / frames_per_second)
    turns = poses[:, : 3 * len(_SMPL)].reshape(len(poses), len(_SMPL), 3)
    rotations = np.tile(np.eye(3), (len(wanted), len(skeleton.JOINTS), 1, 1))
    for s, joint in enumerate(_SMPL):
        if joint is not None:
            j = skeleton.JOINTS.index(joint)
            turned = Rotation.from_rotvec(turns[:, s])
            if len(time) > 1:
                turned = Slerp(time, turned)(wanted)
            rotations[:, j] = rotations[:, j] @ turned.as_matrix()
    rotations[:, 0] = _UPRIGHT.as_matrix() @ rotations[:, 0]
    position = np.stack([np.interp(wanted, time, column) for column in trans.T], axis=1)
    position = _UPRIGHT.apply(position)
    position[:, 1] -= np.median(position[:, 1] - skeleton.standing_height(rotations))
    return skeleton.angles_from_rotations(rotations), position


def _arrays(file: Path) -> tuple[Array, Array, float]:
    """Read and check ``poses``, ``trans`` and the frame rate."""
    try:
        with np.load(file, allow_pickle=False) as stored:
            if not isinstance(stored, np.lib.npyio.NpzFile):
                raise InputError(f"{file}: is no .npz archive but a single array")
            rate_key = next((key for key in _RATES if key in stored), _RATES[0])
            poses, trans, rate = (_numbers(file, stored, k) for k in ("poses", "trans", rate_key))
    except (zipfile.BadZipFile, zlib.error, ValueError, OSError, EOFError, MemoryError) as error:
        raise InputError(f"{file}: is no .npz archive, or damaged ({error})") from error
    columns = 3 * len(_SMPL)
    if poses.ndim != 2 or poses.shape[1] < columns or poses.shape[1] % 3 or not len(poses):
        raise InputError(
            f"{file}: 'poses' has shape {poses.shape}; expected (frames, 156) of SMPL-H or "
            "(frames, 165) of SMPL-X"
        )
    if trans.shape != (len(poses), 3):
        raise InputError(f"{file}: 'trans' has shape {trans.shape}, not ({len(poses)}, 3)")
    for key, values, largest in (
        ("poses", poses[:, :columns], _LARGEST_TURN),
        ("trans", trans, _LARGEST_STEP),
    ):
        bad = ~(np.abs(values) < largest).all(axis=1)
        if bad.any():
            frame = int(np.argmax(bad))
            raise InputError(f"{file}: '{key}' is not finite or huge in frame {frame}")
    if rate.size != 1 or not 1 <= rate.item() <= 10_000:
        raise InputError(f"{file}: '{rate_key}' is {rate}; expected 1 to 10000 frames per second")
    return poses, trans, float(rate.item())


def _numbers(file: Path, stored: np.lib.npyio.NpzFile, key: str) -> Array:
    if key not in stored:
        kind = " or ".join(f"'{k}'" for k in (_RATES if key in _RATES else (key,)))
        raise InputError(f"{file}: has no {kind}, only {', '.join(stored) or 'nothing'}")
    try:
        values = stored[key]
    except (ValueError, EOFError, OSError, MemoryError, zipfile.BadZipFile, zlib.error) as error:
        raise InputError(
            f"{file}: '{key}' cannot be read: it is pickled, which is not opened, or damaged"
        ) from error
    if not np.issubdtype(values.dtype, np.number) or np.iscomplexobj(values):
        raise InputError(f"{file}: '{key}' holds {values.dtype}, not numbers")
    return values.astype(float)
