"""The table of one take's poses as a file, and the counts that an index has of it."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from silpose.core.atomic_files import writing
from silpose.core.errors import InputError
from silpose.fitting import DOUBTFUL
from silpose.model.pose_table import pose_columns, pose_csv
from silpose.model.poses import Poses

_TRACKING = ("tracking", "recovered")

FORMATS = ("csv", "parquet")

COUNTS = ("masks", "blank", "cut", "doubtful", "tracking")
"""Frames of a take that an index counts."""


def write_table(file: Path, poses: Poses, names: list[str]) -> None:
    """Write poses as CSV or, by the file's suffix, Parquet; numbers of the latter are 32 bit."""
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(
            f"cannot write to '{file.parent}' ({error.strerror}): choose another folder by "
            "into=FOLDER"
        ) from error
    with writing(file) as path:
        if file.suffix == ".csv":
            path.write_text(pose_csv(poses, names), encoding="utf-8", newline="")
        else:
            _write_parquet(path, poses, names)


def _write_parquet(path: Path, poses: Poses, names: list[str]) -> None:
    import pyarrow  # slow to load, and not needed for CSV
    import pyarrow.parquet

    columns = {name: _stored(column) for name, column in pose_columns(poses, names).items()}
    pyarrow.parquet.write_table(pyarrow.table(columns), path)


def _stored(column: Any) -> Any:
    if isinstance(column, np.ndarray) and column.dtype.kind == "f":
        return column.astype(np.float32)
    return column if isinstance(column, np.ndarray) else list(column)


def read_table(file: str | Path) -> dict[str, NDArray[Any]]:
    """Read a table of poses back.

    Parameters
    ----------
    file : path
        ``.csv`` or ``.parquet``.

    Returns
    -------
    columns : dict of ndarray, each (F,)
        Numbers where all values are numbers, else text.
    """
    file = Path(file)
    if file.suffix == ".parquet":
        import pyarrow.parquet

        table = pyarrow.parquet.read_table(file)
        return {name: table[name].to_numpy() for name in table.column_names}
    with file.open(newline="", encoding="utf-8") as opened:
        titles, *rows = csv.reader(opened)
    columns = zip(*rows, strict=True) if rows else ([] for _ in titles)
    return {title: _typed(list(column)) for title, column in zip(titles, columns, strict=True)}


def _typed(column: list[str]) -> NDArray[Any]:
    try:
        return np.array(column, dtype=float)
    except ValueError:
        return np.array(column)


def counts_of(poses: Poses) -> dict[str, int]:
    """Count a take's frames."""
    return {
        "masks": len(poses),
        "blank": int((~poses.seen).sum()),
        "cut": 0 if poses.facts is None else int(poses.facts.cut.sum()),
        "doubtful": int((poses.doubtful & poses.seen).sum()),
        "tracking": sum(state in _TRACKING for state in poses.state),
    }


def counts_in(file: Path) -> dict[str, int]:
    """Count the same in a table that was written before."""
    columns = read_table(file)
    known = np.isfinite(columns["heading_deg"]) & (columns["blank"] == 0)
    return {
        "masks": len(known),
        "blank": int(columns["blank"].sum()),
        "cut": int(columns["cut"].sum()),
        "doubtful": int((known & (columns["confidence"] < DOUBTFUL)).sum()),
        "tracking": int(np.isin(columns["state"], _TRACKING).sum()),
    }
