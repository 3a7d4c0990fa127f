"""The end of a sweep: its table in the terminal and as CSV, its figure, what to do next."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from rich.table import Table

from silpose.app.paths import shorten_path
from silpose.app.sweep.figure import sweep_figure
from silpose.app.sweep.outcomes import SEED, Outcome, outcomes, spreads
from silpose.app.sweep.plan import SweepPlan
from silpose.app.terminal import Terminal
from silpose.core.atomic_files import writing
from silpose.core.csv_text import csv_text
from silpose.evaluation.headlines import HEADLINES
from silpose.recording.named_settings import typed
from silpose.recording.runs.sweep_folder import FIGURE

_COMPARED = 4  # runs that one view has room for


@dataclass(frozen=True)
class Done:
    """How many runs of a sweep are finished, and how many failed."""

    finished: int
    failed: int


def report(plan: SweepPlan) -> Done:
    """Print and write the tables and figures of a sweep, one for each of its experiments."""
    finished = failed = 0
    for folder in plan.folders:
        found = outcomes(folder)
        ready = [each for each in found if each.run is not None]
        finished, failed = finished + len(ready), failed + len(found) - len(ready)
        _print(folder, found)
        with writing(folder / "sweep.csv") as path:
            path.write_text(csv_text(_rows(found)), encoding="utf-8", newline="")
        if figure := sweep_figure(ready, f"{folder.parent.name}: {folder.name}"):
            with writing(folder / FIGURE) as path:
                figure.savefig(path, format="png", dpi=120)
    return Done(finished, failed)


def _print(folder: Path, found: Sequence[Outcome]) -> None:
    console = Terminal()
    ready = [each for each in found if each.run is not None]
    if ready:
        console.print(f"{folder.parent.name}: {folder.name}", highlight=False)
        console.print(_table(ready))
    for each in found:
        if each.run is None:
            line = f"{each.folder.name} failed: {each.reason}"
            console.print(line, markup=False, highlight=False, soft_wrap=True)
    for varied, count, values in spreads(found):
        words = "".join(f"; {name}={typed(value)}" for name, value in varied.items())
        line = f"mean ± standard deviation over {count} seeds{words}"
        console.print(line, markup=False, highlight=False, soft_wrap=True)
        console.print(_spread(values))
    best = _best(ready)
    choice = len(best) > 1 and set(best[0].varied) != {SEED}  # seeds are not to be chosen from
    if choice and best[0].run and best[0].run.headline is not None:
        line = f"Lowest headline: {best[0].run.headline:.4g}, of {best[0].folder.name}"
        console.print(line, markup=False, highlight=False, soft_wrap=True)
    recorded = [each for each in best if each.run and each.run.recording.is_file()]
    if len(recorded) > 1:
        names = " ".join(shorten_path(each.folder) for each in recorded[:_COMPARED])
        console.print(f"Side by side:  silpose compare {names}", highlight=False, soft_wrap=True)
    if recorded:
        line = f"All of them:   silpose catalog {shorten_path(folder)}"
        console.print(line, highlight=False, soft_wrap=True)
    names = f"sweep.csv, {FIGURE}" if any(e.run and e.run.headline for e in ready) else "sweep.csv"
    line = f"[dim]in {shorten_path(folder)}: {names}[/dim]"
    console.print(line, highlight=False, soft_wrap=True)


def _table(ready: Sequence[Outcome]) -> Table:
    """Lay out what differs between the runs, a row each."""
    table = Table()
    for name in ready[0].varied:
        table.add_column(name, justify="right", overflow="fold")
    table.add_column("headline", justify="right")
    table.add_column("seconds", justify="right")
    table.add_column("run", overflow="fold")
    for each in ready:
        assert each.run is not None
        headline = "" if each.run.headline is None else f"{each.run.headline:.4g}"
        seconds = f"{sum(each.run.seconds.values()):.1f}"
        settings = [_short(value) for value in each.varied.values()]
        table.add_row(*settings, headline, seconds, each.folder.name)
    return table


def _short(value: object) -> str:
    return f"{value:.4g}" if isinstance(value, float) else typed(value)


def _spread(values: Mapping[str, tuple[float, float]]) -> Table:
    """Lay out mean ± standard deviation over the seeds, a row for each method."""
    table = Table()
    present = {name.rpartition(".")[2] for name in values}
    shown = {name: column for name, column in HEADLINES.items() if name in present}
    table.add_column("method", no_wrap=True)
    for title, _ in shown.values():
        table.add_column(title, justify="right")
    for method in dict.fromkeys(name.rpartition(".")[0] for name in values):
        cells = []
        for name, (_, form) in shown.items():
            pair = values.get(f"{method}.{name}")
            cells.append(_plus_minus(form, *pair) if pair else "")
        table.add_row(method, *cells)
    return table


def _plus_minus(form: str, middle: float, around: float) -> str:
    """Write a mean and a standard deviation, their unit once."""
    return f"{form.format(middle).rstrip(' %°m')} ± {form.format(around)}"


def _best(ready: Sequence[Outcome]) -> list[Outcome]:
    """Sort runs by their headline, where there is one."""
    headlines = {each.folder: each.run.headline for each in ready if each.run is not None}
    known = [each for each in ready if headlines[each.folder] is not None]
    return sorted(known, key=lambda each: headlines[each.folder] or 0.0) or list(ready)


def _rows(found: Sequence[Outcome]) -> Iterable[list[object]]:
    """Lay out ``sweep.csv``: a row for each run, with all its headlines."""
    varied = list(dict.fromkeys(name for each in found for name in each.varied))
    names = list(dict.fromkeys(name for each in found for name in each.values))
    yield ["run", "finished", *varied, "headline", "seconds", *names, "reason"]
    for each in found:
        run = each.run
        headline = run.headline if run and run.headline is not None else ""
        seconds = round(sum(run.seconds.values()), 3) if run else ""
        settings = [typed(each.varied[n]) if n in each.varied else "" for n in varied]
        values = [each.values.get(name, "") for name in names]
        state = "true" if run else "false"
        yield [each.folder.name, state, *settings, headline, seconds, *values, each.reason]
