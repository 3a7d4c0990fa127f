"""Errors of estimated poses.

Each metric takes the pose space, true and estimated poses ``(F, D)`` and the training poses
``(n, D)`` (only to know which angles move), and returns one number.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.core.skeleton import JOINTS
from silpose.core.types import Array
from silpose.evaluation.heading import HEADING_LIMIT_DEG, heading_errors

Metric = Callable[[PoseSpace, Array, Array, Array], float]

LIMB_JOINTS = [
    j
    for j, name in enumerate(JOINTS)
    if name.endswith(("shoulder", "elbow", "wrist", "hip", "knee", "ankle"))
]
_MOVING_DEG = 1.0  # an angle moves if its standard deviation in training is larger


def measure(space: PoseSpace, true: Array, estimated: Array, training: Array) -> dict[str, float]:
    """Evaluate every metric that this pose space has.

    Parameters
    ----------
    space : PoseSpace
    true, estimated : ndarray, shape (F, D)
    training : ndarray, shape (n, D)

    Returns
    -------
    values : dict
        By the metric's name, the reported one first.
    """
    return {name: float(METRICS[name](space, true, estimated, training)) for name in space.metrics}


def joint_distances(space: PoseSpace, true: Array, estimated: Array) -> Array:
    """Distances of the 17 joints other than the root, millimetres, shape (F, 17)."""
    joints = slice(1, len(JOINTS))
    difference = space.joints(true)[:, joints] - space.joints(estimated)[:, joints]
    return 1000 * np.linalg.norm(difference, axis=-1)


def procrustes_distances(space: PoseSpace, true: Array, estimated: Array) -> Array:
    """Distances of the 12 limb joints after the best similarity per frame, mm, shape (F, 12).

    The similarity (rotation, scale, translation) is Umeyama's least-squares one.
    """
    target = space.joints(true)[:, LIMB_JOINTS]
    source = space.joints(estimated)[:, LIMB_JOINTS]
    target = target - target.mean(axis=1, keepdims=True)
    source = source - source.mean(axis=1, keepdims=True)
    u, s, vt = np.linalg.svd(np.swapaxes(target, 1, 2) @ source)
    handedness = np.sign(np.linalg.det(u @ vt))  # a rotation, never a reflection
    s[:, 2] *= handedness
    u[:, :, 2] *= handedness[:, None]
    scale = s.sum(axis=1) / (source**2).sum(axis=(1, 2))
    aligned = scale[:, None, None] * source @ np.swapaxes(u @ vt, 1, 2)
    return 1000 * np.linalg.norm(target - aligned, axis=-1)


def moving_angles(space: PoseSpace, training: Array) -> NDArray[np.bool_]:
    """Angles that vary by more than a degree in training, shape (A,); the heading is the first."""
    moving = space.angles(training).std(axis=0) > _MOVING_DEG
    resultant = float(np.linalg.norm(training[:, :2].mean(axis=0)))  # the heading is on a circle
    moving[0] = np.sqrt(max(-2 * np.log(max(resultant, 1e-12)), 0)) > np.deg2rad(_MOVING_DEG)
    return moving


def _mean_angular(space: PoseSpace, true: Array, estimated: Array, training: Array) -> float:
    return space.angle_errors(true, estimated).mean()


def _moving_angular(space: PoseSpace, true: Array, estimated: Array, training: Array) -> float:
    moving = moving_angles(space, training)
    if not moving.any():  # the training takes hold still
        return float("nan")
    return space.angle_errors(true, estimated)[:, moving].mean()


def _rms_angular(space: PoseSpace, true: Array, estimated: Array, training: Array) -> float:
    return np.sqrt((space.angle_errors(true, estimated) ** 2).mean(axis=0)).mean()


def _joint_distance(space: PoseSpace, true: Array, estimated: Array, training: Array) -> float:
    return space.distance(true, estimated).mean()


METRICS: Mapping[str, Metric] = {
    "mean_angular_error_deg": _mean_angular,
    "moving_angles_error_deg": _moving_angular,
    "rms_angular_error_deg": _rms_angular,
    "mean_joint_distance": _joint_distance,
    "heading_mean_deg": lambda s, t, e, _: heading_errors(s, t, e).mean(),
    "heading_median_deg": lambda s, t, e, _: float(np.median(heading_errors(s, t, e))),
    "heading_rms_deg": lambda s, t, e, _: np.sqrt((heading_errors(s, t, e) ** 2).mean()),
    "heading_over_20deg": lambda s, t, e, _: (heading_errors(s, t, e) > HEADING_LIMIT_DEG).mean(),
    "mpjpe_mm": lambda s, t, e, _: joint_distances(s, t, e).mean(),
    "pa_mpjpe_mm": lambda s, t, e, _: procrustes_distances(s, t, e).mean(),
}
