"""A run of the whole paper: its parts side by side, then the report."""

from __future__ import annotations

import warnings
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
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
_ELSEWHERE = ("recording", "n_jobs", "debug")  # settings that change no result


@dataclass(frozen=True)
class _Run:
    """A part, and the settings that it comes to.

    Attributes
    ----------
    part : Part
    overrides : list of str
    settings : str
        As YAML.
    folder : Path
    """

    part: Part
    overrides: list[str]
    settings: str
    folder: Path

    @classmethod
    def of(cls, part: Part, root: Path) -> _Run:
        """Compose the settings, which fails now rather than after other parts."""
        overrides = [
            f"experiment={part.experiment}", f"seed={part.seed}", "n_jobs=1", *part.overrides,
            f"dataset.cache='{root / 'descriptors'}'",
            f"recording.root='{root}'", f"recording.name='{part.name}'",
        ]  # fmt: skip
        settings = OmegaConf.to_yaml(load(overrides), resolve=True)
        return cls(part, overrides, settings, root / part.experiment / part.name)

    @property
    def name(self) -> str:
        return f"{self.part.name}/{self.part.experiment}"

    def finished(self) -> FinishedRun | None:
        """Read what this run left, if it came to its end with the same settings."""
        try:
            run = load_run(self.folder)
        except InputError:
            return None
        return run if _results_of(run.config) == _results_of(self.settings) else None


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
    runs = [_Run.of(part, root) for part in parts_of(options)]
    left = [run for run in runs if run.finished() is None]
    failed = {}
    with parallel_config(n_jobs=n_jobs):
        for name, reason in parallel_stream(_do, left, description="parts of the paper"):
            if reason:
                failed[name] = reason
    found, seconds = _results(runs)
    report = PaperReport(found, seconds, failed, root, _FAST if options.fast else "")
    root.mkdir(parents=True, exist_ok=True)
    write_paper(report)
    return report


def _do(run: _Run) -> tuple[str, str]:
    """Run a part, in whatever process this is; its name, and why it failed if it did."""
    from silpose.app.failures import sentence

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # the parts share their data's doubts
            run_experiment(run.overrides)
    except Exception as error:
        return run.name, sentence(error).removeprefix("silpose: ")
    return run.name, ""


def _results_of(settings: str) -> dict[str, Any]:
    """Keep the settings that results depend on."""
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    own: dict[str, Any] = yaml.load(settings, loader)
    return {name: value for name, value in own.items() if name not in _ELSEWHERE}


def _results(runs: Sequence[_Run]) -> tuple[dict[str, dict[str, Found]], dict[str, float]]:
    """Gather what finished parts found, by protocol and experiment, and their seconds."""
    by_protocol: dict[str, dict[str, list[FinishedRun]]] = defaultdict(lambda: defaultdict(list))
    seconds = {}
    for run in runs:
        if (finished := run.finished()) is not None:
            by_protocol[run.part.protocol][run.part.experiment].append(finished)
            seconds[run.name] = sum(finished.seconds.values())
    found = {
        protocol: {name: Found(own) for name, own in by_experiment.items()}
        for protocol, by_experiment in by_protocol.items()
    }
    return found, seconds
