"""What the terminal shows when a run is finished."""

from __future__ import annotations

from rich.console import Console, Group
from rich.markup import escape
from rich.table import Table

from silpose.app.paths import pasted, rerun_command, shorten_path
from silpose.app.terminal import Terminal
from silpose.core.stage_lines import animated
from silpose.evaluation import best_first, explanations, headlines, in_parts
from silpose.evaluation.headlines import HEADLINES, Results
from silpose.experiments import CATALOGUE
from silpose.experiments.catalogue import Entry
from silpose.recording import FinishedRun

_BETWEEN = 3  # characters between two columns


def summarise(run: FinishedRun) -> None:
    """Print the results of a run, and the line that opens its recording."""
    console = Terminal()
    if run.report:
        console.print(run.report, markup=False, highlight=False, soft_wrap=True)
    if run.metrics:
        console.print(results(run, console.width))
        for words in explanations(run.metrics):
            console.print(f"[dim]{escape(words)}[/dim]", highlight=False)
    if run.summary and not run.report:  # which says it
        console.print(run.summary, markup=False, highlight=False, soft_wrap=True)
    if not animated(Console(stderr=True)):  # else each stage has a line that tells its seconds
        took = ", ".join(f"{stage} {s:.1f} s" for stage, s in run.seconds.items())
        console.print(f"[dim]{took}[/dim]", soft_wrap=True)
    if recorded := run.recording.is_file():
        opening = f"{rerun_command()} {pasted(run.recording)}"
        console.print(f"Open it:  {escape(opening)}", highlight=False, soft_wrap=True)
    place = "beside it" if recorded else f"in {shorten_path(run.folder)}"
    beside = sorted(f.name for f in run.folder.iterdir() if f != run.recording)
    console.print(f"[dim]{escape(place)}: {', '.join(beside)}[/dim]", soft_wrap=True)


def results(run: FinishedRun, width: int = 80) -> Group:
    """Lay the headlines out, a row per method, the best first.

    Parameters
    ----------
    run : FinishedRun
    width : int, default=80
        Characters of a line. Columns that do not fit stand in further tables below.
    """
    ordered, best = best_first(run.metrics)
    entry = CATALOGUE.get(run.experiment, Entry(""))
    tables: list[Table] = []
    for group in _with_columns_in_common(ordered):
        some = {method: ordered[method] for method in group}
        tables += _tables(entry.rows, some, best, width)
    tables[0].title = f"{escape(run.dataset)}: {entry.table}"
    return Group(*tables)


def _tables(first: str, ordered: Results, best: str | None, width: int) -> list[Table]:
    (_, *titles), rows = headlines(ordered)
    columns = list(zip(titles, *(own for _, *own in rows), strict=True))
    least = [max(map(len, (*title.split(), *values))) for title, *values in columns]
    room = width - max(map(len, (first, *ordered))) - (_BETWEEN + 1)
    tables: list[Table] = []
    for part in in_parts([own + _BETWEEN for own in least], room):
        table = Table(title_justify="left", title_style="")
        table.add_column(first, no_wrap=True)
        spare = room - sum(least[k] + _BETWEEN for k in part)
        for k in part:
            wide = min(max(len(titles[k]), least[k]), least[k] + spare)
            table.add_column(titles[k], justify="right", width=wide)
            spare -= wide - least[k]
        for method, *values in rows:
            if tables and not any(values[k] for k in part):
                continue  # the first table names all of them
            style = "bold" if method == best else ""
            table.add_row(escape(method), *(values[k] for k in part), style=style)
        tables.append(table)
    return tables


def _with_columns_in_common(results: Results) -> list[list[str]]:
    """Group methods, so that tables of those without a column in common are not half empty."""
    groups: list[tuple[set[str], list[str]]] = []
    for method, values in results.items():
        columns, members = set(values) & set(HEADLINES), [method]
        for group in [own for own in groups if own[0] & columns or own[0] == columns]:
            groups.remove(group)
            columns, members = columns | group[0], [*group[1], *members]
        groups.append((columns, members))
    return [[method for method in results if method in members] for _, members in groups]
