"""Errors in heading, and what the norm of an estimated heading says about them (section IV-B)."""

from __future__ import annotations

import numpy as np

from silpose.core.pose_space import PoseSpace, wrap_degrees
from silpose.core.types import Array, Row

HEADING_LIMIT_DEG = 20.0
"""A heading that is off by more counts as wrong, in every metric."""


def heading_errors(space: PoseSpace, true: Array, estimated: Array) -> Array:
    """Absolute differences of the headings, degrees, shape (F,)."""
    return np.abs(wrap_degrees(space.heading(true) - space.heading(estimated)))


def heading_confidence(space: PoseSpace, true: Array, estimated: Array) -> dict[str, float]:
    """Relate the norm of the estimated (cos, sin) to the error in heading.

    Parameters
    ----------
    space : PoseSpace
    true, estimated : ndarray, shape (F, D)

    Returns
    -------
    values : dict
        ``heading_norm_good`` and ``heading_norm_bad``: mean norm on frames whose heading is less,
        or more, than 20 degrees off; ``heading_norm_correlation``: of the norm with the error.
        Left out where there are no such frames.
    """
    norm, error = space.heading_norm(estimated), heading_errors(space, true, estimated)
    bad = error > HEADING_LIMIT_DEG
    values = {}
    if (~bad).any():
        values["heading_norm_good"] = float(norm[~bad].mean())
    if bad.any():
        values["heading_norm_bad"] = float(norm[bad].mean())
    if norm.std() > 0 and error.std() > 0:
        values["heading_norm_correlation"] = float(np.corrcoef(norm, error)[0, 1])
    return values


def key_angles(space: PoseSpace, true: Array, estimated: Array) -> list[Row]:
    """RMS error beside the range of motion, for heading, left shoulder and right hip.

    Of each joint the angle of largest range, as the paper gives them; joint positions have the
    heading only.

    Parameters
    ----------
    space : PoseSpace
    true, estimated : ndarray, shape (F, D)

    Returns
    -------
    rows : list of dict
        ``metric``, ``value`` (RMS error, degrees), ``range_deg``.

    References
    ----------
    Section IV-B and Fig. 10 of the paper.
    """
    turned = np.ptp(np.unwrap(np.deg2rad(space.heading(true))))
    error = heading_errors(space, true, estimated)
    rows = [_row("heading", error, min(float(np.rad2deg(turned)), 360.0))]
    angles, errors = space.angles(true), space.angle_errors(true, estimated)
    for joint in ("left_shoulder", "right_hip"):
        own = [k for k, name in enumerate(space.angle_names) if name.startswith(joint)]
        if own:
            widest = max(own, key=lambda k: np.ptp(angles[:, k]))
            extent = float(np.ptp(angles[:, widest]))
            rows.append(_row(space.angle_names[widest], errors[:, widest], extent))
    return rows


def _row(name: str, error: Array, extent: float) -> Row:
    rms = float(np.sqrt((error**2).mean()))
    return {"metric": f"{name}_rms_deg", "value": rms, "range_deg": extent}
