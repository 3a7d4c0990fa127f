"""A run of the whole paper: its parts side by side, then the report."""

from __future__ import annotations

import warnings
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import yaml
from joblib import parallel_config
from omegaconf import OmegaConf

from silpose.app.config import load
from silpose.app.paper.options import PaperOptions
from silpose.app.paper.parts import Part, parts_of
from silpose.app.run import run_experiment
from silpose.core.errors import InputError
from silpose.core.parallel import parallel_stream
from silpose.recording import FinishedRun, load_run
from silpose.recording.paper import Found, PaperReport, write_paper

_FAST = "This was a fast pass on a few seconds of motion in small images: a check, not results."
_ELSEWHERE = ("recording", "n_jobs", "engine", "address", "debug")  # settings that change no result


@dataclass(frozen=True)
class _Run:
    """The settings that a part comes to.

    Attributes
    ----------
    overrides : list of str
    settings : str
        As YAML.
    folder : Path
    """

    overrides: list[str]
    settings: str
    folder: Path

    @classmethod
    def of(cls, part: Part, root: Path) -> _Run:
        """Compose the settings.

        Raises
        ------
        InputError
            If a setting does not exist.
        """
        overrides = [
            f"experiment={part.experiment}", f"seed={part.seed}", "n_jobs=1", *part.overrides,
            f"recording.root='{root}'", f"recording.name='{part.name}'",
        ]  # fmt: skip
        settings = OmegaConf.to_yaml(load(overrides), resolve=True)
        return cls(overrides, settings, root / part.experiment / part.name)

    def result(self) -> FinishedRun | None:
        """Read what this run left, if it came to its end with the same settings."""
        try:
            run = load_run(self.folder)
        except InputError:
            return None
        return run if _results_of(run.config) == _results_of(self.settings) else None


@dataclass(frozen=True)
class _Done:
    """What became of a part.

    Attributes
    ----------
    part : Part
    name : str
    result : FinishedRun or None
        None if it failed,
    reason : str
        and why.
    """

    part: Part
    name: str
    result: FinishedRun | None
    reason: str = ""


def run_paper(options: PaperOptions, *, n_jobs: int = -1) -> PaperReport:
    """Run every part that is not finished, and write the report.

    Parameters
    ----------
    options : PaperOptions
    n_jobs : int, default=-1
        Number of parts side by side; -1 is one per processor.

    Returns
    -------
    report : PaperReport
        A part that failed is in it with its reason; the others are run all the same.

    Raises
    ------
    InputError
        If an option or a setting does not exist.
    """
    root = Path(options.root).absolute() / (options.name or ("fast" if options.fast else "whole"))
    parts = parts_of(options)
    _Run.of(parts[0], root)  # a setting that does not exist fails now, not in each of them
    with parallel_config(n_jobs=n_jobs):
        stream = parallel_stream(partial(_do, root), parts, description="parts of the paper")
        done = sorted(stream, key=lambda own: parts.index(own.part))
    found, seconds = _results(done)
    failed = {own.name: own.reason for own in done if own.result is None}
    report = PaperReport(found, seconds, failed, root, _FAST if options.fast else "")
    root.mkdir(parents=True, exist_ok=True)
    write_paper(report)
    return report


def _do(root: Path, part: Part) -> _Done:
    """Run a part that is not finished, in whatever process this is."""
    from silpose.app.failures import sentence

    name = f"{part.name}/{part.experiment}"
    try:
        run = _Run.of(part, root)
        if run.result() is None:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", UserWarning)  # parts share their data's doubts
                run_experiment(run.overrides)
    except Exception as error:
        return _Done(part, name, None, sentence(error).removeprefix("silpose: "))
    return _Done(part, name, run.result(), "it left no result")


def _results_of(settings: str) -> dict[str, Any]:
    """Keep the settings that results depend on."""
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    own: dict[str, Any] = yaml.load(settings, loader)
    return {name: value for name, value in own.items() if name not in _ELSEWHERE}


def _results(done: Sequence[_Done]) -> tuple[dict[str, dict[str, Found]], dict[str, float]]:
    """Gather what finished parts found, by protocol and experiment, and their seconds."""
    by_protocol: dict[str, dict[str, list[FinishedRun]]] = defaultdict(lambda: defaultdict(list))
    seconds = {}
    for own in done:
        if own.result is not None:
            by_protocol[own.part.protocol][own.part.experiment].append(own.result)
            seconds[own.name] = sum(own.result.seconds.values())
    found = {
        protocol: {name: Found(own) for name, own in by_experiment.items()}
        for protocol, by_experiment in by_protocol.items()
    }
    return found, seconds
