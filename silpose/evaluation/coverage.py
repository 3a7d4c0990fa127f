"""Coverage: how often the truth lies in the intervals that an estimate's covariance gives."""

from __future__ import annotations

from statistics import NormalDist

import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import ANGLES as SPACE
from silpose.core.skeleton import JOINTS
from silpose.core.types import Array, Row

Covered = NDArray[np.bool_]

LEVEL = 0.9
"""Probability of the intervals whose coverage is measured."""

_STEP_DEG = 0.01  # of the differences that carry a covariance from angles to joints


def angles_covered(
    true: Array, estimated: Array, covariance: Array, level: float = LEVEL
) -> Covered:
    """Find the angles whose true value lies in the interval around the estimated one.

    Parameters
    ----------
    true, estimated : ndarray, shape (F, 55)
    covariance : ndarray, shape (F, 54, 54)
        Of the estimated angles, degrees².
    level : float, default=0.9
        Probability of the interval.

    Returns
    -------
    covered : ndarray of bool, shape (F, 54)
    """
    deviation = np.sqrt(np.diagonal(covariance, axis1=1, axis2=2))
    return SPACE.angle_errors(true, estimated) <= _half_width(level) * deviation


def joints_covered(
    true: Array, estimated: Array, covariance: Array, level: float = LEVEL
) -> Covered:
    """Find the joints' coordinates whose true value lies in the interval around the estimated one.

    Joints are relative to the root. They move linearly with small changes of the angles, which
    carries the covariance over.

    Parameters
    ----------
    true, estimated : ndarray, shape (F, 55)
    covariance : ndarray, shape (F, 54, 54)
        Of the estimated angles, degrees².
    level : float, default=0.9
        Probability of the interval.

    Returns
    -------
    covered : ndarray of bool, shape (F, 17, 3)
        Of the joints other than the root: along the image's x and y, and in depth.
    """
    joints = slice(1, len(JOINTS))
    angles, place = SPACE.angles(estimated), SPACE.joints(estimated)[:, joints]
    slopes = np.empty((*place.shape, angles.shape[1]))
    for a in range(angles.shape[1]):
        moved = angles.copy()
        moved[:, a] += _STEP_DEG
        slopes[..., a] = (SPACE.joints(SPACE.from_angles(moved))[:, joints] - place) / _STEP_DEG
    spread = slopes.reshape(len(place), -1, angles.shape[1])
    variance = np.einsum("fka,fka->fk", spread @ covariance, spread).reshape(place.shape)
    off = np.abs(SPACE.joints(true)[:, joints] - place)
    return off <= _half_width(level) * np.sqrt(np.maximum(variance, 0)) + 1e-9


def coverage_by_limb(
    true: Array, estimated: Array, covariance: Array, level: float = LEVEL
) -> list[Row]:
    """Measure the coverage of each body part: its angles, its joints in the image and in depth.

    Parameters
    ----------
    true, estimated : ndarray, shape (F, 55)
    covariance : ndarray, shape (F, 54, 54)
        Of the estimated angles, degrees². Frames where it is NaN do not count.
    level : float, default=0.9
        Probability of the intervals.

    Returns
    -------
    rows : list of dict
        ``part`` (``body`` is the whole), ``metric`` (``coverage_angles``, ``coverage_image``,
        ``coverage_depth``), ``value`` (0 to 1); none where no frame counts.
    """
    known = np.isfinite(covariance).all(axis=(1, 2))
    if not known.any():
        return []
    given = true[known], estimated[known], covariance[known], level
    angles, joints = angles_covered(*given), joints_covered(*given)
    rows: list[Row] = []
    for part in ("body", *SPACE.parts):
        names = _joints_of(part)
        own = [a for a, name in enumerate(SPACE.angle_names) if SPACE.joint_of(name) in names]
        places = [j for j, name in enumerate(JOINTS[1:]) if name in names]
        covered = {
            "coverage_angles": angles[:, own],
            "coverage_image": joints[:, places, :2],
            "coverage_depth": joints[:, places, 2],
        }
        rows += [
            {"part": part, "metric": name, "value": float(c.mean())} for name, c in covered.items()
        ]
    return rows


def _half_width(level: float) -> float:
    """Half of the interval's width, in standard deviations."""
    return NormalDist().inv_cdf((1 + level) / 2)


def _joints_of(part: str) -> set[str]:
    if part == "body":
        return set(JOINTS)
    return {SPACE.joint_of(SPACE.columns[c]) for c in SPACE.parts[part]}
