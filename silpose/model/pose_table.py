"""Poses as a table: one row per mask."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from silpose.model.poses import Poses

Column = NDArray[np.generic] | list[str] | range


def pose_columns(poses: Poses, names: Sequence[str]) -> Mapping[str, Column]:
    """Lay poses out as columns, each of F values.

    Parameters
    ----------
    poses : Poses
        Of masks.
    names : sequence of str
        What the masks are called.

    Returns
    -------
    columns : mapping of str to sequence
        ``frame``, ``file``, ``time`` (seconds), ``state``, ``blank`` (1 where nobody was seen),
        ``cut`` (1 where the frame cuts the person), ``confidence``, of a fit ``iou``, heading and
        its norm, all angles (degrees) and joints (metres), which are NaN where there is no pose.
    """
    facts, space = poses.facts, poses.space
    columns: dict[str, Column] = {
        "frame": range(len(poses)),
        "file": list(names),
        "time": poses.time,
        "state": poses.state,
    }
    if facts is not None:
        columns |= {"blank": (~facts.seen).astype(np.int8), "cut": facts.cut.astype(np.int8)}
    columns["confidence"] = poses.confidence
    if poses.iou is not None:
        columns["iou"] = poses.iou
    columns |= {"heading_deg": poses.heading, "heading_norm": poses.heading_norm}
    columns |= {f"{c}_deg": poses.x[:, 2 + k] for k, c in enumerate(space.columns[2:])}
    joints = poses.joints
    for j, joint in enumerate(space.joint_names):
        columns |= {f"{joint}_{axis}_m": joints[:, j, k] for k, axis in enumerate("xyz")}
    return columns


def pose_csv(poses: Poses, names: Sequence[str]) -> str:
    """Write poses as CSV, a line per mask; columns as `pose_columns`, numbers with six digits."""
    return columns_csv(pose_columns(poses, names), ("frame", "file", "time"))


def columns_csv(columns: Mapping[str, Column], first: Sequence[str]) -> str:
    """Write columns as CSV: the first ones, then those of words, then those of numbers."""
    words = [name for name, column in columns.items() if not _is_float(column)]
    titles = [*first, *(name for name in words if name not in first)]
    numbers = [name for name in columns if name not in titles]
    values = np.column_stack([np.asarray(columns[name]) for name in numbers]).tolist()
    spelled = ",".join(["%.6g"] * len(numbers))
    before = [_spelled(columns[name]) for name in titles]
    lines = (
        f"{','.join(row)},{spelled % tuple(own)}\n"
        for *row, own in zip(*before, values, strict=True)
    )
    return ",".join([*titles, *numbers]) + "\n" + "".join(lines)


def _is_float(column: Column) -> bool:
    return isinstance(column, np.ndarray) and column.dtype.kind == "f"


def _spelled(column: Column) -> list[str]:
    """Write whole numbers, seconds, and text, which is quoted where it has to be."""
    if _is_float(column):
        return [f"{value:.6f}".rstrip("0").rstrip(".") for value in column]
    return [_quoted(str(value)) for value in column]


def _quoted(text: str) -> str:
    plain = not any(sign in text for sign in ',"\r\n')
    return text if plain else '"{}"'.format(text.replace('"', '""'))
