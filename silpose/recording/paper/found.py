"""What runs of one experiment found: values as words, with their spread over seeds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from silpose.recording.runs.finished_run import FinishedRun

_ERRORS = ("mean_angular_error_deg", "mean_joint_distance", "whole_error", "error")
_UNITS = {"mean_joint_distance": "", "rms_angular_error_deg": "°"}


@dataclass(frozen=True)
class Found:
    """Values of one experiment on one protocol.

    Attributes
    ----------
    runs : sequence of FinishedRun
        One for each seed, at least one.
    """

    runs: Sequence[FinishedRun]

    @property
    def run(self) -> FinishedRun:
        """The run of the first seed, whose figure and recording are shown."""
        return self.runs[0]

    @property
    def methods(self) -> list[str]:
        """Methods, or whatever else the experiment has values of."""
        return list(self.run.metrics)

    def error_of(self, method: str) -> str:
        """Name of the error that a method has, by the measure of the dataset.

        Raises
        ------
        LookupError
            If the experiment has no such method, or it has no error.
        """
        found = [name for name in _ERRORS if name in self.run.metrics[method]]
        if not found:
            raise LookupError(f"'{method}' has no error")
        return found[0]

    def value(self, method: str, name: str | None = None) -> float:
        """Mean over the seeds; of the error, where no name is given."""
        return float(self._values(method, name).mean())

    def words(self, method: str, name: str | None = None, *, percent: bool = False) -> str:
        """Mean over the seeds, with its standard deviation where there are several, and unit."""
        name = name or self.error_of(method)
        unit = "%" if percent else _UNITS.get(name, "°" if name in _ERRORS else "")
        own = self._values(method, name) * (100 if percent else 1)
        digits = 0 if percent else 2
        if len(own) == 1:
            return f"{own[0]:.{digits}f}{unit}"
        return f"{own.mean():.{digits}f} ± {own.std(ddof=1):.{digits}f}{unit}"

    def row(self, **wanted: str) -> dict[str, str]:
        """First row of ``results.csv`` with these values."""
        return self.rows(**wanted)[0]

    def rows(self, **wanted: str) -> list[dict[str, str]]:
        """All rows of ``results.csv`` with these values.

        Raises
        ------
        LookupError
            If there is none.
        """
        found = [row for row in self.run.rows if wanted.items() <= row.items()]
        if not found:
            raise LookupError(f"results.csv has no row with {wanted}")
        return found

    def _values(self, method: str, name: str | None) -> np.ndarray:
        name = name or self.error_of(method)
        return np.array([run.metrics[method][name] for run in self.runs])
