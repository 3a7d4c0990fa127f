"""Poses over time as gait analysis takes them: places of the legs, times, path, confidence."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.core import skeleton
from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.core.types import Array
from silpose.evaluation.gait.checks import check_legs, check_path, numbers, shaped, times_of

SIDES = ("left", "right")

_LEG = ("hip", "knee", "ankle", "toes")
_HEEL, _BALL = 0, 1  # rows of a sole


@dataclass(frozen=True)
class Walk:
    """Poses over time, checked; make it by `from_poses` or `from_joints`.

    Attributes
    ----------
    time : ndarray, shape (F,)
        Seconds, increasing.
    points : dict of str to ndarray, shape (F, 3)
        Hip, knee, ankle, heel and toes of either side, such as ``left_heel``; metres, relative to
        the root, +Y up. NaN where there is no pose.
    trunk : ndarray, shape (F, 3)
        Direction against which the hips bend: the pelvis's axis, or from the hips to the neck.
    path : ndarray of shape (F, 3) or None
        Places of the root, metres.
    confidence : ndarray, shape (F,)
        0 to 1; 1 where none is known.
    """

    time: Array
    points: dict[str, Array]
    trunk: Array
    path: Array | None
    confidence: Array

    def __len__(self) -> int:
        return len(self.time)

    @classmethod
    def from_poses(
        cls,
        x: ArrayLike,
        *,
        frames_per_second: float | None = None,
        time: ArrayLike | None = None,
        path: ArrayLike | None = None,
        confidence: ArrayLike | None = None,
        camera_azimuth: ArrayLike = 0.0,
        scale: float = 1.0,
    ) -> Walk:
        """Take pose vectors.

        Parameters
        ----------
        x : array-like, shape (F, 55)
            A frame without a pose is NaN.
        frames_per_second : float or None, default=None
            Rate of the frames, if `time` is not given.
        time : array-like of shape (F,) or None, default=None
            Seconds of the frames.
        path : array-like of shape (F, 3) or None, default=None
            Places of the root, metres, +Y up. By default it is found from the foot that stands.
        confidence : array-like of shape (F,) or None, default=None
            How sure each pose is, 0 to 1.
        camera_azimuth : array-like, scalar or of shape (F,), default=0.0
            Azimuth of the direction from the person to the camera in the world of `path`, degrees:
            headings of poses are relative to it; `azimuth_of_camera` gives it for a camera at rest.
        scale : float, default=1.0
            Size of the person over that of the skeleton, whose leg is 0.80 m.

        Raises
        ------
        InputError
            If an argument has another shape, or values that cannot be used.
        """
        x = numbers("poses", x)
        if x.ndim != 2 or x.shape[1] != len(ANGLES.columns):
            raise InputError(
                f"poses for a gait report must have shape (frames, 55), not {x.shape}; joint "
                "positions go into Walk.from_joints"
            )
        azimuth = numbers("camera_azimuth", camera_azimuth)
        if azimuth.shape not in ((), (len(x),)):
            raise InputError(
                f"camera_azimuth must be a number or one a frame, not of shape {azimuth.shape}"
            )
        angles = ANGLES.angles(x)
        angles[:, 0] += azimuth
        known = np.asarray(np.isfinite(angles).all(axis=1))
        places, turned = skeleton.forward_kinematics(
            skeleton.rotations_from_angles(np.where(known[:, None], angles, 0.0))
        )
        points = {f"{s}_{p}": _point(places, f"{s}_{p}") for s in SIDES for p in _LEG}
        for side in SIDES:
            ankle = f"{side}_ankle"
            sole = turned[:, skeleton.JOINTS.index(ankle)] @ skeleton.SOLES[ankle].T
            points[f"{side}_heel"] = points[ankle] + sole[..., _HEEL]
            points[f"{side}_toes"] = points[ankle] + sole[..., _BALL]
        return cls._checked(
            points, turned[:, 0, :, 1], known, frames_per_second, time, path, confidence, scale
        )

    @classmethod
    def from_joints(
        cls,
        joints: ArrayLike,
        names: Sequence[str] = skeleton.POINTS,
        *,
        frames_per_second: float | None = None,
        time: ArrayLike | None = None,
        path: ArrayLike | None = None,
        confidence: ArrayLike | None = None,
    ) -> Walk:
        """Take joint positions, whose heels are taken to be behind and below the ankles.

        Parameters
        ----------
        joints : array-like, shape (F, J, 3)
            Metres, +Y up, relative to the root if `path` is given. A frame without a pose is NaN.
        names : sequence of str, default=silpose.core.skeleton.POINTS
            Of the J joints: hips, knees, ankles and toes of either side, and the neck.
        frames_per_second, time, path, confidence
            As in `from_poses`; without a path, a joint called ``root`` gives it if it moves.

        Raises
        ------
        InputError
            If an argument has another shape, or a joint is missing.
        """
        joints = numbers("joints", joints)
        if joints.ndim != 3 or joints.shape[1:] != (len(names), 3):
            raise InputError(
                f"joints for a gait report must have shape (frames, {len(names)}, 3), as there are "
                f"{len(names)} names, not {joints.shape}"
            )
        wanted = [f"{side}_{point}" for side in SIDES for point in _LEG] + ["neck"]
        if missing := [name for name in wanted if name not in names]:
            raise InputError(
                f"a gait report needs the joint '{missing[0]}', which is not among the names of "
                "the joints: rename the joint that it is, or give pose vectors to Walk.from_poses"
            )
        found = {name: joints[:, list(names).index(name)] for name in wanted}
        known = np.asarray(np.isfinite(np.stack(list(found.values()))).all(axis=(0, 2)))
        middle = (found["left_hip"] + found["right_hip"]) / 2
        if path is None and "root" in names:
            root = joints[:, list(names).index("root")]
            if np.ptp(root[known], axis=0).max(initial=0.0) > 1e-6:
                path, middle = root, middle - root
                found = {name: place - root for name, place in found.items()}
        trunk = found.pop("neck") - middle
        check_legs(found["left_ankle"] - found["left_hip"])
        for side in SIDES:
            shin = found[f"{side}_ankle"] - found[f"{side}_knee"]
            foot = found[f"{side}_toes"] - found[f"{side}_ankle"]
            found[f"{side}_heel"] = found[f"{side}_ankle"] + 0.17 * shin - 0.35 * foot
        return cls._checked(found, trunk, known, frames_per_second, time, path, confidence, 1.0)

    @classmethod
    def _checked(
        cls,
        points: dict[str, Array],
        trunk: Array,
        known: NDArray[np.bool_],
        frames_per_second: float | None,
        time: ArrayLike | None,
        path: ArrayLike | None,
        confidence: ArrayLike | None,
        scale: float,
    ) -> Walk:
        frames = len(known)
        seconds = times_of(frames, frames_per_second, time)
        if not 0 < scale < np.inf:
            raise InputError(f"scale must be a positive number, not {scale}")
        if path is not None:
            path = shaped("path", path, (frames, 3))
            known = known & np.asarray(np.isfinite(path).all(axis=1))
            check_path(path, seconds)
        sure = np.ones(frames)
        if confidence is not None:
            sure = shaped("confidence", confidence, (frames,))
            if ((sure < 0) | (sure > 1)).any():
                raise InputError("confidence must be between 0 and 1 in every frame, or NaN")
        sure = np.where(known & np.isfinite(sure), sure, 0.0)
        lost = ~known[:, None]
        points = {name: np.where(lost, np.nan, scale * own) for name, own in points.items()}
        return cls(seconds, points, np.where(lost, np.nan, trunk), path, sure)

    @property
    def known(self) -> NDArray[np.bool_]:
        """Whether there is a pose, and a place if there is a path; shape (F,), of bool."""
        return np.asarray(np.isfinite(self.trunk).all(axis=1))


def _point(places: Array, name: str) -> Array:
    return places[:, skeleton.POINTS.index(name)]
