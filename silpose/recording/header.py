"""What a recording says about itself: its name, its texts, its properties, where it goes."""

from __future__ import annotations

import platform
import shutil
import subprocess
import zlib
from dataclasses import dataclass, field
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

import yaml

from silpose.evaluation.headlines import Results, headlines
from silpose.recording import entity_paths
from silpose.recording.runs.setting_differences import flat, typed
from silpose.recording.sinks import Sinks


@dataclass(frozen=True)
class Header:
    """Head of a recording.

    Attributes
    ----------
    experiment, run : str
    file : Path
        Of the ``.rrd``.
    words : str
        What was seen, as markdown.
    settings : str
        Of the run, as YAML; "" if it has none.
    results : mapping
        Values by method.
    sinks : Sinks
    """

    experiment: str
    run: str
    file: Path
    words: str
    settings: str = ""
    results: Results = field(default_factory=dict)
    sinks: Sinks = field(default_factory=Sinks)

    @property
    def name(self) -> str:
        """What the viewer calls the recording."""
        return f"{self.experiment}/{self.run}"

    @property
    def identity(self) -> str:
        """Unlike that of any other run: runs of one name under two roots are not the same run."""
        return f"{self.name}/{zlib.crc32(self.settings.encode()):08x}"

    def texts(self) -> dict[str, str]:
        """Write what was seen, settings and headline results as markdown, by entity."""
        told = f"{self.words}\n\n{results_table(self.results)}" if self.results else self.words
        texts = {entity_paths.SEQUENCE: self.words, entity_paths.METRICS: told}
        if self.settings:
            shown = yaml.safe_dump(self._choices(), sort_keys=False, allow_unicode=True)
            texts[entity_paths.SETTINGS] = f"```yaml\n{shown}```\n"
        return texts

    def properties(self) -> dict[str, dict[str, Any]]:
        """Give what a catalog shows as a row: by group and name, settings and versions as text."""
        values = {
            f"{method}.{name}": float(value)
            for method, own in self.results.items()
            for name, value in own.items()
        }
        groups: dict[str, dict[str, Any]] = {
            # As text: what is a number here may be a list, or nothing, in the next run.
            "settings": {n: typed(v) for n, v in flat(self._choices()) if v is not None},
            "metrics": values,
            "versions": versions(),
        }
        return {group: values for group, values in groups.items() if values}

    def _choices(self) -> dict[str, Any]:
        """All settings but where the recording goes: they make the run what it is."""
        choices = yaml.safe_load(self.settings) or {}
        return {name: value for name, value in choices.items() if name != "recording"}


def results_table(results: Results) -> str:
    """Write the headlines as a markdown table, a row per method."""
    titles, rows = headlines(results)
    ruler = ":--|" + "--:|" * (len(titles) - 1)
    table = [" | ".join(titles), ruler.strip("|"), *(" | ".join(row) for row in rows)]
    return "\n".join(f"| {line} |" for line in table)


@cache
def versions() -> dict[str, str]:
    """Versions of what makes a recording, and the commit if silpose is a checkout."""
    found = {
        "silpose": version("silpose"),
        "rerun": version("rerun-sdk"),
        "python": platform.python_version(),
    }
    root = Path(__file__).parents[2]
    if (root / ".git").exists() and (git := shutil.which("git")):
        told = subprocess.run(
            [git, "-C", str(root), "describe", "--always", "--dirty", "--exclude=*", "--abbrev=12"],
            capture_output=True,
            text=True,
        )
        if told.returncode == 0:
            found["commit"] = told.stdout.strip()
    return found
