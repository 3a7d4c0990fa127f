"""The header of a recording: its name, its texts, its properties, where it goes."""

from __future__ import annotations

import platform
import shutil
import subprocess
import zlib
from dataclasses import dataclass, field
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import yaml

from silpose.recording import entity_paths
from silpose.recording.named_settings import flat, typed
from silpose.recording.runs.setting_differences import determines_results, differing
from silpose.recording.sinks import Sinks

if TYPE_CHECKING:
    from silpose.evaluation.headlines import Results

ROOM = 34
"""Characters of a line in the narrowest pane that shows results, in a window of 1024 pixels."""

_GAP = 2  # characters between columns


@dataclass(frozen=True)
class Header:
    """Name, texts, properties and destination of a recording.

    Attributes
    ----------
    experiment, run : str
    file : Path
        The ``.rrd`` file.
    words : str
        What is recorded, as markdown.
    settings : str, default=""
        Settings of the run as YAML; empty where there are none.
    defaults : str, default=""
        What they would be had nobody chosen any, as YAML; only those that differ are shown.
    results : mapping, default={}
        Values by method, then by name.
    sinks : Sinks or None, default=None
        Where the recording goes; None writes the file alone.
    figure : Path or None, default=None
        PNG of the experiment's figure, for the recordings that show it.
    rows : str, default="method"
        What each row of the results is.
    """

    experiment: str
    run: str
    file: Path
    words: str
    settings: str = ""
    results: Results = field(default_factory=dict)
    sinks: Sinks | None = None
    figure: Path | None = None
    defaults: str = ""
    rows: str = "method"

    @property
    def name(self) -> str:
        """Name of the recording in the viewer."""
        return f"{self.experiment}/{self.run}"

    @property
    def identity(self) -> str:
        """Identifier of the recording: two runs of one name with other settings differ in it."""
        return f"{self.name}/{zlib.crc32(self.settings.encode()):08x}"

    def texts(self, room: int = ROOM) -> dict[str, str]:
        """Words, settings and headline results as markdown, by entity.

        Tables of results are as wide as there is room, in characters.
        """
        results = results_tables(self.results, self.rows, room) if self.results else []
        texts = {
            entity_paths.TAKE: self.words,
            entity_paths.METRICS: "\n\n".join([self.words, *results]),
        }
        if self.settings:
            texts[entity_paths.SETTINGS] = self._settings_in_words()
        return texts

    def properties(self) -> dict[str, dict[str, Any]]:
        """Row of the recording in a catalog, by group and name: settings, metrics, versions."""
        values = {
            f"{method}.{name}": float(value)
            for method, own in self.results.items()
            for name, value in own.items()
        }
        groups: dict[str, dict[str, Any]] = {
            # As text: what is a number here may be a list, or nothing, in the next run.
            "settings": {
                name: typed(value)
                for name, value in flat(yaml.safe_load(self.settings) or {})
                if value is not None and determines_results(name)
            },
            "metrics": values,
            "versions": versions(),
        }
        return {group: values for group, values in groups.items() if values}

    def _settings_in_words(self) -> str:
        """List the settings that differ from the defaults, as one would type them."""
        both = [yaml.safe_load(text) or {} for text in (self.settings, self.defaults)]
        chosen = {name: value for name, value in differing(both)[0].items() if value is not None}
        if not chosen:
            return "All settings have their defaults."
        typed_ = "\n".join(f"{name}={typed(value)}" for name, value in chosen.items())
        return f"Settings that differ from the defaults:\n\n```\n{typed_}\n```\n"


def results_tables(results: Results, of: str = "method", room: int = ROOM) -> list[str]:
    """Headlines as markdown tables, a row of each method or the like, the best first and bold.

    The viewer breaks no line of a table: columns for which there is no room, in characters, stand
    in further tables.
    """
    from silpose.evaluation import best_first, headlines, in_parts

    ordered, best = best_first(results)
    (_, *titles), rows = headlines(ordered)
    columns = zip(titles, *(values for _, *values in rows), strict=True)
    widths = [max(map(len, column)) + _GAP for column in columns]
    tables: list[str] = []
    for part in in_parts(widths, room - max(map(len, (of, *ordered)))):
        lines = [[of, *(titles[k] for k in part)], [":--", *["--:"] * len(part)]]
        for method, *values in rows:
            own = [values[k] for k in part]
            if tables and not any(own):
                continue  # the first table names all of them
            row = [method, *own]
            lines.append([f"**{cell}**" if cell and method == best else cell for cell in row])
        tables.append("\n".join(f"| {' | '.join(line)} |" for line in lines))
    return tables


@cache
def versions() -> dict[str, str]:
    """Versions of the programs that make a recording, and the commit of a checkout of silpose."""
    found = {
        "silpose": version("silpose"),
        "rerun": version("rerun-sdk"),
        "python": platform.python_version(),
    }
    root = Path(__file__).parents[2]
    if (root / ".git").exists() and (git := shutil.which("git")):
        described = subprocess.run(
            [git, "-C", str(root), "describe", "--always", "--dirty", "--exclude=*", "--abbrev=12"],
            capture_output=True,
            text=True,
        )
        if described.returncode == 0:
            found["commit"] = described.stdout.strip()
    return found
