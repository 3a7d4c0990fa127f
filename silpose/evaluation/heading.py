"""What the paper says of headings and of its three key angles (section IV-B, Fig. 10)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import AnglePoseSpace, PoseSpace
from silpose.evaluation.metrics import heading_errors

Array = NDArray[np.float64]

MISESTIMATED = 20.0  # degrees off in heading


def heading_confidence(space: PoseSpace, true: Array, estimated: Array) -> dict[str, float]:
    """Relate the norm of the estimated (cos, sin) to the error in heading.

    Returns
    -------
    values : dict
        ``heading_norm_good`` and ``heading_norm_bad``: mean norm on frames whose heading is less,
        or more, than 20 degrees off; ``heading_norm_correlation``: of the norm with the error.
        Left out where there are no such frames.
    """
    norm, off = space.heading_norm(estimated), heading_errors(space, true, estimated)
    bad = off > MISESTIMATED
    varies = norm.std() > 0 and off.std() > 0
    values = {}
    if (~bad).any():
        values["heading_norm_good"] = float(norm[~bad].mean())
    if bad.any():
        values["heading_norm_bad"] = float(norm[bad].mean())
    if varies:
        values["heading_norm_correlation"] = float(np.corrcoef(norm, off)[0, 1])
    return values


def key_angles(space: PoseSpace, true: Array, estimated: Array) -> list[dict[str, object]]:
    """RMS error beside the range of motion, for heading, left shoulder and right hip.

    Of each joint the angle of largest range, as the paper gives them; joint positions have the
    heading only.

    Returns
    -------
    rows : list of dict
        ``metric``, ``value`` (RMS error, degrees), ``range_deg``.
    """
    rows: list[dict[str, object]] = []
    off = heading_errors(space, true, estimated)
    turned = np.ptp(np.unwrap(np.deg2rad(space.heading(true))))
    _row(rows, "heading", off, min(float(np.rad2deg(turned)), 360.0))
    if isinstance(space, AnglePoseSpace):
        names = space.columns[1:]
        angles, errors = space.angles(true), space.angle_errors(true, estimated)
        for joint in ("left_shoulder", "right_hip"):
            own = [k for k, name in enumerate(names) if name.startswith(joint)]
            widest = max(own, key=lambda k: np.ptp(angles[:, k]))
            _row(rows, names[widest], errors[:, widest], float(np.ptp(angles[:, widest])))
    return rows


def _row(rows: list[dict[str, object]], name: str, off: Array, extent: float) -> None:
    rms = float(np.sqrt((off**2).mean()))
    rows.append({"metric": f"{name}_rms_deg", "value": rms, "range_deg": extent})
