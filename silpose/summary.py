"""What a run says in the terminal when it is done."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

from rich.console import Console
from rich.table import Table

from silpose.run import FinishedRun

_HEADLINES = {
    "mean_angular_error_deg": ("angles", "{:.2f}°"),
    "mean_joint_distance": ("joints, own units", "{:.2f}"),
    "heading_median_deg": ("heading", "{:.1f}°"),
    "heading_over_20deg": ("off by 20°", "{:.0%}"),
    "mpjpe_mm": ("joints", "{:.0f} mm"),
    "log_likelihood": ("log-likelihood", "{:.1f}"),
    "frames": ("frames", "{:.0%}"),
    "frames_by_neighbours": ("frames, by like silhouettes", "{:.0%}"),
    "frames_by_modes": ("frames, by modes", "{:.0%}"),
    "found_by_modes": ("found", "{:.0%}"),
    "error_of_first": ("error of mode 1", "{:.2f}"),
    "error_of_better": ("of the better", "{:.2f}"),
    "error": ("error", "{:.2f}"),
    "mean_pose_error": ("mean pose", "{:.2f}"),
    "functions_kept": ("functions kept", "{:.0f}"),
    "points_share": ("points retained", "{:.0%}"),
    "kept": ("kernels", "{:.0%}"),
    "extinct": ("frames extinct", "{:.0%}"),
    "widest_error": ("worst widths", "{:.2f}"),
    "locked_on": ("starts that lock on", "{:.0%}"),
    "within_20deg": ("heading within 20°", "{:.0%}"),
}


def summarise(run: FinishedRun) -> None:
    """Print the results of a run, and the line that opens its recording."""
    console = Console()
    if run.metrics:
        console.print(results(run))
    took = ", ".join(f"{stage} {s:.1f} s" for stage, s in run.seconds.items())
    console.print(f"[dim]{took}[/dim]", soft_wrap=True)
    console.print(f"Open it:  {rerun_command()} {near(run.recording)}", soft_wrap=True)
    beside = sorted(f.name for f in run.folder.iterdir() if f != run.recording)
    console.print(f"[dim]beside it: {', '.join(beside)}[/dim]", soft_wrap=True)


def results(run: FinishedRun) -> Table:
    """Lay the headlines out, a row per method."""
    table = Table(title=f"{run.dataset}: errors on unseen sequences", title_justify="left")
    table.add_column("method")
    present = {n for values in run.metrics.values() for n in values}
    shown = {n: c for n, c in _HEADLINES.items() if n in present}
    for title, _ in shown.values():
        table.add_column(title, justify="right")
    for method, values in run.metrics.items():
        cells = [f.format(values[n]) if n in values else "" for n, (_, f) in shown.items()]
        table.add_row(method, *cells)
    return table


def rerun_command() -> str:
    """Name the viewer so that it can be typed here: it may live in an environment of its own."""
    beside = Path(sys.executable).with_name("rerun")
    if shutil.which("rerun") or not beside.exists():
        return "rerun"
    return near(beside)


def near(path: Path) -> str:
    """Shorten a path that lies below the working folder."""
    full = os.path.abspath(path)  # not resolved: a virtual environment's links are to stay
    below = os.path.relpath(full)
    return full if below.startswith("..") else below
