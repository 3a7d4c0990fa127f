"""Poses for every take of a tree: a table each, in parallel, resumable."""

from __future__ import annotations

import hashlib
import tempfile
import warnings
from contextlib import nullcontext
from dataclasses import asdict, dataclass
from functools import lru_cache, partial
from pathlib import Path

import numpy as np
from joblib import parallel_config

from silpose.core.errors import InputError
from silpose.core.parallel import parallel_stream
from silpose.core.parameters import check_values, one_of
from silpose.model.answers import UNCALIBRATED, rate_wanted, warn_without_calibration
from silpose.model.loading import load
from silpose.model.pose_model import PoseModel
from silpose.model.poses import Poses
from silpose.model.trees.take_table import COUNTS, FORMATS, counts_in, counts_of, write_table
from silpose.model.trees.tree_index import TreeIndex
from silpose.silhouette.mask_tree import MaskTake, TreePattern, find_takes
from silpose.silhouette.masks import MaskSource, why_no_masks

_FEW = 8  # takes for which other processes are not worth their start
_NAMED = 3  # takes that a warning names


@dataclass(frozen=True)
class TreeAnswer:
    """What was done with a tree.

    Attributes
    ----------
    folder : Path
        Holds the tables, and ``takes.csv``.
    takes, done_before, failed : int
        Takes of the tree; those that were finished before; those that could not be used.
    counts : dict of int
        Frames in all takes that are finished, by what they are.
    """

    folder: Path
    takes: int
    done_before: int
    failed: int
    counts: dict[str, int]

    def summary(self) -> str:
        """Say it in one line."""
        parts = [f"{self.takes} takes", f"{self.counts['masks']} masks"]
        parts += [f"{self.counts[name]} {name}" for name in COUNTS[1:4] if self.counts[name]]
        if self.counts["tracking"]:
            parts.append(f"tracking in {self.counts['tracking']}")
        if self.done_before:
            parts.append(f"{self.done_before} takes were finished before")
        if self.failed:
            parts.append(f"{self.failed} takes could not be used")
        return f"{', '.join(parts)}: see {self.folder / 'takes.csv'}"


@dataclass(frozen=True)
class _Work:
    """What a process needs to know to do a take."""

    model: str
    options: MaskSource
    lag: float
    fit: bool
    folder: Path
    suffix: str


def predict_tree(
    model: PoseModel,
    root: str | Path,
    into: str | Path,
    *,
    pattern: str | None = None,
    options: MaskSource | None = None,
    lag: float = 0.5,
    fit: bool = False,
    table: str = "csv",
) -> TreeAnswer:
    """Estimate the poses of all takes of a tree.

    Parameters
    ----------
    model : PoseModel
        One that tracks needs the takes' rate: their own, or that of the options.
    root : path
        Folder of folders of masks, at any depth.
    into : path
        Folder of the tables, laid out as the tree is, and of their index ``takes.csv``. What is
        finished there is not done again.
    pattern : str, optional
        Levels of the tree, such as ``subject/sequence/view``, which are columns of the index
        then; see `TreePattern`.
    options : MaskSource, optional
        How masks are read; blank ones are rows without a pose.
    lag : float, default=0.5
        Seconds that a tracker may wait for later frames.
    fit : bool, default=False
        Whether to fit the body to the masks of each take.
    table : {"csv", "parquet"}, default="csv"

    Returns
    -------
    answer : TreeAnswer

    Raises
    ------
    InputError
        If there is no take, or tables cannot be written; or if a tracker needs the takes' rate.

    Warns
    -----
    UserWarning
        If takes could not be used, or there are doubts about them; all are named in the index.
    """
    check_values("table", one_of(*FORMATS), table)
    root, levels = Path(root), TreePattern.of(pattern)
    takes = list(find_takes(root, levels))
    if not takes:
        raise InputError(_no_takes(root, pattern))
    options = MaskSource(**(asdict(options or MaskSource()) | {"source": None, "blank": "nan"}))
    if model.tracker and not (fit or options.frames_per_second) and takes[0].path.is_dir():
        raise InputError(rate_wanted(f"the takes below '{root}'", model.frames_per_second))
    folder = Path(into)
    with tempfile.TemporaryDirectory() as temporary:
        saved = Path(temporary) / "model.npz"
        model.save(saved)
        work = _Work(str(saved), options, lag, fit, folder, f".{table}")
        settings = {"tree": str(root.resolve()), "model": _digest(saved), "lag": lag}
        settings |= {"fit": fit, "table": table}
        settings |= asdict(options)
        index = TreeIndex.open(folder, settings)
        left = [take for take in takes if not index.is_done(take.name, take.changed)]
        alone = parallel_config(n_jobs=1) if len(left) < _FEW else nullcontext()
        with alone:
            for row in parallel_stream(partial(_do, work), left, description="takes"):
                index.add(row)
    index.finish(((take.name, levels.parts(take.name)) for take in takes), levels.columns)
    rows = [index.rows[take.name] for take in takes]
    failed = [row for row in rows if row["error"]]
    _warn_of(failed, "error", "could not be used", folder)
    _warn_of([row for row in rows if row["doubts"]], "doubts", "may be wrong", folder)
    if model.confidence is None:
        warn_without_calibration()
    counts = {n: sum(int(row[n]) for row in rows if not row["error"]) for n in COUNTS}
    return TreeAnswer(folder, len(takes), len(takes) - len(left), len(failed), counts)


def _do(work: _Work, take: MaskTake) -> dict[str, object]:
    """Write the table of a take; return its row of the index."""
    name = f"{take.name}{work.suffix}"
    row: dict[str, object] = {"take": take.name, "table": name}
    with warnings.catch_warnings(record=True) as doubts:
        warnings.simplefilter("always", UserWarning)
        try:
            row["source_changed"] = take.changed
            file = work.folder / name
            if _is_newer(file, take):  # finished, but not in the index before the run was killed
                return row | counts_in(file)
            poses, names = _answer(_loaded(work.model), take, work)
            write_table(file, poses, names)
        except (InputError, OSError) as error:
            return row | {"table": "", "error": str(error)}
    said = [str(doubt.message) for doubt in doubts if str(doubt.message) != UNCALIBRATED]
    return row | counts_of(poses) | {"doubts": "; ".join(said)}


def _answer(model: PoseModel, take: MaskTake, work: _Work) -> tuple[Poses, list[str]]:
    options = work.options.reading
    details = model.explain(take.path, **options)
    if work.fit or model.tracker is None:
        return model.predict(details, fit=work.fit), details.names
    rate = details.frames_per_second or 0.0  # asked for where it is not known
    return model.track(details, lag=round(work.lag * rate)), details.names


def _is_newer(file: Path, take: MaskTake) -> bool:
    return file.is_file() and file.stat().st_mtime_ns > take.changed


@lru_cache(maxsize=1)
def _loaded(path: str) -> PoseModel:
    """Load the model once in each process."""
    return load(path)


def _digest(file: Path) -> str:
    """Identify a model by its arrays."""
    with np.load(file, allow_pickle=False) as arrays:
        digest = hashlib.sha256()
        for name in sorted(arrays.files):
            if name != "header":
                digest.update(name.encode() + arrays[name].tobytes())
    return digest.hexdigest()[:16]


def _warn_of(rows: list[dict[str, str]], why: str, words: str, folder: Path) -> None:
    if rows:
        named = "; ".join(f"'{row['take']}': {row[why]}" for row in rows[:_NAMED])
        more = f"; and {len(rows) - _NAMED} more" if len(rows) > _NAMED else ""
        takes = "take" if len(rows) == 1 else "takes"
        warnings.warn(
            f"{len(rows)} {takes} {words}, see {folder / 'takes.csv'}: {named}{more}", stacklevel=3
        )


def _no_takes(root: Path, pattern: str | None) -> str:
    found = next(find_takes(root), None)
    other = None if found else why_no_masks(root)
    if other:
        return f"there are no masks below '{root}'; {other}"
    if pattern is None:
        return f"there are no masks below '{root}': give a folder of folders of mask images"
    example = f", such as '{found.name}'" if found else ""
    return f"no take below '{root}' fits pattern={pattern}: takes are folders of masks{example}"
