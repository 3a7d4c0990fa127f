"""Reading a recording back as data."""

from __future__ import annotations

import re
import warnings
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from rerun.chunk import Chunk, RrdReader

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.recording import entity_paths

_MAGIC = b"RRF2"  # first bytes of a file of Rerun's, before its version
_POSES = (
    (entity_paths.TRUE_POSE, "true"),
    (entity_paths.ESTIMATED_POSE, "estimated"),
    (entity_paths.FITTED_POSE, "fitted"),
    (f"{entity_paths.TRACKS}/([^/]+)/pose", "{1}"),
    (f"{entity_paths.MODES}/([^/]+)/pose", "mode_{1}"),
    (f"{entity_paths.HYPOTHESES}/([^/]+)/pose", "hypothesis_{1}"),
)


@dataclass(frozen=True)
class RecordedPoses:
    """Poses and errors that a recording holds.

    Attributes
    ----------
    time : ndarray, shape (F,)
        Seconds from the take's start; empty if there are no poses.
    frames : ndarray of int, shape (F,)
        Their numbers, of which live recordings may leave some out.
    columns : tuple of str
        Names of the D columns of pose vectors.
    poses : dict of str to ndarray, shape (F, D)
        ``true`` where the ground truth is known; ``estimated``, or one for each method that was
        drawn. A frame without an estimate is a row of NaN.
    errors : dict of str to ndarray, shape (F,)
        Error of each method.
    """

    time: Array
    frames: NDArray[np.int64]
    columns: tuple[str, ...]
    poses: dict[str, Array]
    errors: dict[str, Array]


def reader(recording: str | Path) -> RrdReader:
    """Open a recording.

    Raises
    ------
    InputError
        If there is none, or it is cut off, or of another version of Rerun.
    """
    path = Path(recording)
    if not path.is_file():
        raise InputError(f"there is no recording '{path}'")
    with path.open("rb") as file:
        start = file.read(8)
    if start[:4] != _MAGIC:
        raise InputError(f"'{path}' is no recording of this version of Rerun, nor of a near one")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Rerun's own words for a file that was cut off
            opened = RrdReader(path)
            empty = not opened.recordings()
            opened.store()
            next(iter(opened.stream()), None)  # nothing before it looks at the version
    except Exception as error:
        raise _unreadable(path, start) from error
    if empty:
        raise InputError(f"'{path}' holds no recording")
    return opened


def _unreadable(path: Path, start: bytes) -> InputError:
    theirs, ours = f"{start[4]}.{start[5]}", ".".join(version("rerun-sdk").split(".")[:2])
    if theirs != ours:
        return InputError(
            f"'{path}' was written by Rerun {theirs}, which Rerun {ours} cannot read: "
            "run the experiment again"
        )
    return InputError(f"'{path}' was cut off: 'silpose repair {path}' salvages what is in it")


def read_poses(recording: str | Path) -> dict[str, Array]:
    """Read the pose vectors of a recording.

    Parameters
    ----------
    recording : path
        An ``.rrd`` file.

    Returns
    -------
    poses : dict of str to ndarray, shape (F, D)
        As `RecordedPoses.poses`.
    """
    return read_recording(recording).poses


def read_recording(recording: str | Path) -> RecordedPoses:
    """Read the poses and errors of a recording.

    Parameters
    ----------
    recording : path
        An ``.rrd`` file. In one of several runs side by side, names begin with the run's.

    Returns
    -------
    recorded : RecordedPoses
    """
    poses, errors = _Rows(), _Rows()
    columns: tuple[str, ...] = ()
    for chunk in reader(recording).stream().filter(content=["/**"]):
        name, rows = _name(chunk.entity_path), poses
        if name is None:
            name, rows = _name_of_error(chunk.entity_path), errors
        if name is None:
            continue
        if not chunk.is_static:
            rows.add(name, chunk)
        elif rows is poses:
            batch = chunk.to_record_batch()
            columns = tuple(batch.column("columns")[0].as_py())
    frames, times = poses.frames_and_times()
    of_methods = {name: values[:, 0] for name, values in errors.values().items()}
    return RecordedPoses(times, frames, columns, poses.values(), of_methods)


def frames_of(recording: str | Path) -> range:
    """Frames of a recording, from the first to the last; none if it does not change over time.

    Parameters
    ----------
    recording : path
        An ``.rrd`` file.
    """
    ends = [
        int(end)
        for chunk in reader(recording).stream()
        if "frame" in chunk.timeline_names
        for frames in (np.asarray(chunk.to_record_batch().column("frame")),)
        if len(frames)
        for end in (frames.min(), frames.max())
    ]
    return range(min(ends), max(ends) + 1) if ends else range(0)


class _Rows:
    """Rows of numbers by name, put in the order of their frames."""

    def __init__(self) -> None:
        self._parts: dict[str, list[tuple[NDArray[np.int64], Array, Array]]] = {}

    def add(self, name: str, chunk: Chunk) -> None:
        batch = chunk.to_record_batch()
        numbers = batch.column(batch.schema.names[-1])
        values = np.asarray(numbers.flatten(), dtype=float).reshape(batch.num_rows, -1)
        times = np.asarray(batch.column("time")).astype("timedelta64[ns]").astype(float) / 1e9
        self._parts.setdefault(name, []).append((np.asarray(batch.column("frame")), times, values))

    def frames_and_times(self) -> tuple[NDArray[np.int64], Array]:
        longest = max(self._parts, key=lambda n: sum(len(p[0]) for p in self._parts[n]), default="")
        return self._ordered(longest)[:2] if longest else (np.empty(0, np.int64), np.empty(0))

    def values(self) -> dict[str, Array]:
        return {name: self._ordered(name)[2] for name in sorted(self._parts)}

    def _ordered(self, name: str) -> tuple[NDArray[np.int64], Array, Array]:
        frames, times, values = map(np.concatenate, zip(*self._parts[name], strict=True))
        order = np.argsort(frames, kind="stable")
        return frames[order], times[order], values[order]


def _name(entity: str) -> str | None:
    """Name of the poses of an entity; None if it holds none."""
    for path, name in _POSES:
        if found := re.fullmatch(rf"/?(.*?){path}", entity):
            return "/".join(filter(None, (found[1], name.format(*found.groups()))))
    return None


def _name_of_error(entity: str) -> str | None:
    if found := re.fullmatch(rf"/?(.*?){entity_paths.ERROR}/(.+)", entity):
        return "/".join(filter(None, found.groups()))
    return None
