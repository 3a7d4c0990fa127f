"""Folders of runs: made, filled with an experiment's result, read back, compared and served.

An experiment returns a `Result`; `write_result` puts it into a `RunFolder`; `load_run` and
`runs_table` read such folders again.
"""

from typing import TYPE_CHECKING

from silpose.core.lazy_exports import lazy_exports

if TYPE_CHECKING:
    from silpose.recording.runs.comparison import compare
    from silpose.recording.runs.finished_run import FinishedRun, load_poses, load_run, runs_table
    from silpose.recording.runs.rerun_catalog import catalog
    from silpose.recording.runs.result import Recording, Result
    from silpose.recording.runs.run_folder import RunFolder
    from silpose.recording.runs.runs_below import find_runs, newest_run
    from silpose.recording.runs.server import serve
    from silpose.recording.runs.write import write_result

# On first use: comparing loads Rerun, and reading a run back does not.
__getattr__ = lazy_exports(
    __name__,
    {
        "rerun_catalog": ("catalog",),
        "comparison": ("compare",),
        "finished_run": ("FinishedRun", "load_poses", "load_run", "runs_table"),
        "result": ("Recording", "Result"),
        "run_folder": ("RunFolder",),
        "runs_below": ("find_runs", "newest_run"),
        "server": ("serve",),
        "write": ("write_result",),
    },
)

__all__ = [
    "FinishedRun",
    "Recording",
    "Result",
    "RunFolder",
    "catalog",
    "compare",
    "find_runs",
    "load_poses",
    "load_run",
    "newest_run",
    "runs_table",
    "serve",
    "write_result",
]
