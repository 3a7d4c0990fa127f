"""What an experiment hands over to be written, recorded and shown."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from silpose.core.types import Metrics, Row

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from silpose.model import PoseModel
    from silpose.recording.header import Header


@dataclass(frozen=True)
class Recording:
    """A recording that is still to be written.

    Attributes
    ----------
    words : str
        What is recorded, as markdown.
    write : callable
        Writes the recording under a `Header`: one of the ``record_…`` functions, its other
        arguments given already.
    """

    words: str
    write: Callable[[Header], None]


@dataclass
class Result:
    """What an experiment found; `write_result` writes it.

    Attributes
    ----------
    dataset : str
    metrics : dict
        Headline values by method, then by name.
    rows : list of dict
        Lines of ``results.csv``: one per method, setting and value.
    figure : matplotlib.figure.Figure or None
    recording : Recording or None
    model : PoseModel or None
    headline : float or None
        What a sweep minimises: the validation error of what the experiment is about. None where
        nothing is chosen.
    tables : mapping of str to str
        Further tables, as CSV, by the name of their file (``poses.csv``).
    files : mapping of str to callable
        Functions that write further files to a path, by the names of the files (``track.npz``).
    used_model : str or None
        Path of a model that an earlier run trained, whose settings are written as this run's.
    summary : str
        What the terminal says at the end, in one line; empty where metrics say it.
    report : str
        Text for the terminal, and for the file ``report.txt``.

    See Also
    --------
    silpose.recording.write_result : Writes it into the folder of a run.
    """

    dataset: str
    metrics: Metrics
    rows: list[Row] = field(default_factory=list)
    figure: Figure | None = None
    recording: Recording | None = None
    model: PoseModel | None = None
    headline: float | None = None
    tables: Mapping[str, str] = field(default_factory=dict)
    files: Mapping[str, Callable[[Path], None]] = field(default_factory=dict)
    used_model: str | None = None
    summary: str = ""
    report: str = ""
