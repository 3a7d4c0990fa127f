"""A run's folder: made when a run starts, filled file by file."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING

from silpose.core.atomic_files import writing
from silpose.core.errors import InputError
from silpose.recording.sinks import Sinks

if TYPE_CHECKING:
    from silpose.recording import Header


@dataclass
class Run:
    """One run of an experiment, with a folder of its own.

    Attributes
    ----------
    experiment, name : str
        The folder is ``<root>/<experiment>/<name>``.
    folder : Path
    settings : str
        As YAML.
    sinks : Sinks
        Where its recording goes.
    seconds : dict
        How long each stage took.
    """

    experiment: str
    name: str
    folder: Path
    settings: str
    sinks: Sinks = field(default_factory=Sinks)
    seconds: dict[str, float] = field(default_factory=dict)

    @classmethod
    def start(
        cls,
        root: str,
        experiment: str,
        name: str | None = None,
        settings: str = "",
        sinks: Sequence[str] = ("file",),
        viewer_port: int = Sinks.viewer_port,
        web_port: int = Sinks.web_port,
    ) -> Run:
        """Make the run's folder below a root; without a name it gets the next free number."""
        opened = Sinks(sinks, viewer_port, web_port)
        if name is not None and Path(name).name != name:
            raise InputError(f"recording.name is the name of one folder, not '{name}'")
        parent = Path(root) / experiment
        try:
            parent.mkdir(parents=True, exist_ok=True)
            taken = [int(f.name) for f in parent.iterdir() if f.name.isdigit()]
            number = max(taken, default=0) + 1
            while True:  # another process may take the same number first
                folder = parent / (name or f"{number:03d}")
                try:
                    folder.mkdir(exist_ok=name is not None)
                    (folder / ".partial").touch()
                    (folder / ".partial").unlink()
                    return cls(experiment, folder.name, folder, settings, opened)
                except FileExistsError:
                    number += 1
        except OSError as error:
            raise InputError(
                f"cannot write to '{parent}' ({error.strerror}): choose another recording.root"
            ) from error

    def abandon(self) -> None:
        """Remove the folder if nothing was finished in it."""
        for folder in (self.folder, self.folder.parent):
            if not any(folder.iterdir()):
                folder.rmdir()

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Time what happens inside."""
        started = perf_counter()
        yield
        self.seconds[name] = self.seconds.get(name, 0.0) + perf_counter() - started

    @contextmanager
    def writing(self, file: str) -> Iterator[Path]:
        """Give a path to write to; the file gets its name only once it is whole."""
        with writing(self.folder / file) as path:
            yield path

    def header(self, words: str, results: Mapping[str, Mapping[str, float]]) -> Header:
        """Head the run's recording: what was seen, in words, and the values of every method."""
        from silpose.recording import Header

        file = self.folder / "run.rrd"
        return Header(self.experiment, self.name, file, words, self.settings, results, self.sinks)

    def write_settings(self) -> None:
        """Write ``config.yaml``."""
        with self.writing("config.yaml") as path:
            path.write_text(self.settings, encoding="utf-8")

    def write_metrics(
        self, dataset: str, seed: int, metrics: Mapping[str, Mapping[str, float]]
    ) -> None:
        """Write ``metrics.json``: the headline values of every method."""
        content = {
            "experiment": self.experiment,
            "dataset": dataset,
            "seed": seed,
            "seconds": {stage: round(s, 3) for stage, s in self.seconds.items()},
            "metrics": metrics,
        }
        with self.writing("metrics.json") as path:
            path.write_text(json.dumps(content, indent=2) + "\n", encoding="utf-8")

    def write_results(self, rows: Sequence[Mapping[str, object]]) -> None:
        """Write ``results.csv``: one row per method, setting and value."""
        columns = list(dict.fromkeys(column for row in rows for column in row))
        with (
            self.writing("results.csv") as path,
            path.open("w", newline="", encoding="utf-8") as file,
        ):
            writer = csv.DictWriter(file, columns, lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
