"""Errors joint by joint and angle by angle, twists apart."""

from __future__ import annotations

import numpy as np

from silpose.core.pose_space import PoseSpace
from silpose.core.skeleton import JOINTS, LIMBS, OFFSETS
from silpose.core.types import Array, Row
from silpose.evaluation.metrics import joint_distances

TWIST_ANGLES: tuple[str, ...] = tuple(
    f"{joint}_{'xyz'[int(np.abs(OFFSETS[end]).argmax())]}" for joint, end in LIMBS.items()
)
"""Angles that turn a limb about its own bone, which an outline hardly shows."""


def twist_errors(space: PoseSpace, true: Array, estimated: Array) -> dict[str, float]:
    """Measure the angles that turn a limb about its own bone, and all others.

    Parameters
    ----------
    space : PoseSpace
    true, estimated : ndarray, shape (F, D)

    Returns
    -------
    values : dict
        ``twist_error_deg`` and ``other_angles_error_deg``, mean absolute differences.
    """
    errors = space.angle_errors(true, estimated).mean(axis=0)
    twists = np.isin(space.angle_names, TWIST_ANGLES)
    return {
        "twist_error_deg": float(errors[twists].mean()),
        "other_angles_error_deg": float(errors[~twists].mean()),
    }


def error_rows(space: PoseSpace, true: Array, estimated: Array) -> list[Row]:
    """List the mean error of each joint and of each angle.

    Parameters
    ----------
    space : PoseSpace
    true, estimated : ndarray, shape (F, D)

    Returns
    -------
    rows : list of dict
        ``joint``, ``metric`` (``mpjpe_mm``), ``value`` for the 17 joints other than the root;
        ``angle``, ``twist`` (whether it turns a limb about its own bone), ``metric``
        (``mean_angular_error_deg``), ``value`` for the angles.
    """
    distances = joint_distances(space, true, estimated).mean(axis=0)
    errors = space.angle_errors(true, estimated).mean(axis=0)
    joints: list[Row] = [
        {"joint": joint, "metric": "mpjpe_mm", "value": float(value)}
        for joint, value in zip(JOINTS[1:], distances, strict=True)
    ]
    return joints + [
        {
            "angle": angle,
            "twist": angle in TWIST_ANGLES,
            "metric": "mean_angular_error_deg",
            "value": float(value),
        }
        for angle, value in zip(space.angle_names, errors, strict=True)
    ]
