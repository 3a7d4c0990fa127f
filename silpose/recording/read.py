"""Reading a recording back as data."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from rerun.chunk import RrdReader

from silpose.errors import InputError
from silpose.recording import entities

Array = NDArray[np.float64]

_POSE = "/pose"  # how the entities end that hold pose vectors


def reader(recording: str | Path) -> RrdReader:
    """Open a recording, or say why it cannot be."""
    path = Path(recording)
    if not path.is_file():
        raise InputError(f"there is no recording '{path}'")
    try:
        opened = RrdReader(path)
        recordings = opened.recordings()
    except Exception as error:
        raise InputError(
            f"'{path}' cannot be read as a recording: it may be cut off, or of another version "
            "of Rerun; 'rerun rrd migrate' or running the experiment again may help"
        ) from error
    if not recordings:
        raise InputError(f"'{path}' holds no recording")
    return opened


def read_poses(recording: str | Path) -> dict[str, Array]:
    """Read the pose vectors of a recording.

    Parameters
    ----------
    recording : path
        Of an ``.rrd`` file.

    Returns
    -------
    poses : dict of str to ndarray, shape (F, D)
        ``true`` where the truth is known; ``estimated``, or one for each method that was drawn. A
        frame without an answer is a row of NaN.
    """
    poses: dict[str, list[tuple[NDArray[np.int64], Array]]] = {}
    for chunk in reader(recording).stream().filter(content=["/**"], is_static=False):
        if not chunk.entity_path.endswith(_POSE):
            continue
        batch = chunk.to_record_batch()
        rows = next(c for c in batch.schema.names if c.endswith("Scalars:scalars"))
        frames = np.asarray(batch.column("frame"))
        values = np.array(batch.column(rows).to_pylist(), dtype=float)
        poses.setdefault(_name(chunk.entity_path), []).append((frames, values))
    return {
        name: np.concatenate([v for _, v in parts])[
            np.argsort(np.concatenate([f for f, _ in parts]), kind="stable")
        ]
        for name, parts in sorted(poses.items())
    }


def _name(entity: str) -> str:
    if entity == entities.TRUE_POSE:
        return "true"
    if entity == entities.ESTIMATED_POSE:
        return "estimated"
    return entity.removesuffix(_POSE).rpartition("/")[2]
