"""A page that lists a folder's runs, each with its figure, headlines and recording."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from html import escape
from itertools import count
from pathlib import Path
from urllib.parse import quote

from silpose.core.types import Metrics
from silpose.recording.named_settings import typed
from silpose.recording.page_style import PAGE_HEAD, PAGE_STYLE
from silpose.recording.runs.finished_run import FinishedRun, found_in_words
from silpose.recording.runs.runs_below import find_runs
from silpose.recording.runs.setting_differences import differing, parsed
from silpose.recording.runs.sweep_folder import FIGURE, SWEEP

_STYLE = (
    PAGE_STYLE
    + """
h2 { margin: 2.5em 0 0; } h2 + p { margin: .2em 0 1em; color: var(--dim); }
td { vertical-align: top; white-space: nowrap; } .word { text-align: left; white-space: normal; }
.sweep button img { width: 18em; }
.set { font-size: 13px; overflow-wrap: anywhere; min-width: 9em; }
button { padding: 0; border: 0; background: none; cursor: zoom-in; display: block; }
button img { width: 9em; height: auto; border-radius: 4px; display: block; }
[popover] { border: 0; padding: 0; background: none; }
[popover] button, [popover] img { width: auto; }
[popover] img { max-width: 96vw; max-height: 94vh; cursor: zoom-out; }
[popover]::backdrop { background: #000c; }
@media (max-width: 600px) {
  table, tbody, tr, td { display: block; } tr:first-child { display: none; }
  tr { border: 1px solid var(--line); border-radius: 6px; margin: 1em 0; padding: .6em; }
  td, td.word { border: 0; text-align: right; display: flex; gap: 1em; padding: .2em; }
  td { justify-content: space-between; } td:empty { display: none; }
  td::before { content: attr(data-title); color: var(--dim); }
  td.figure { display: block; } td.figure::before { content: none; }
  button, button img { width: 100%; }
}
"""
)
_CLASSES = {"figure": "figure", "differs in": "word set"}  # of cells, by their titles
_MOST = 8  # settings of a run, at most, in which it differs from others


def index_page(
    root: Path, viewed: Callable[[str], str], questions: Mapping[str, str] | None = None
) -> str:
    """Write the page as HTML, the latest run first.

    Parameters
    ----------
    root : Path
        Folder whose runs are listed, at any depth.
    viewed : callable
        From a recording's path below the root to the address that shows it.
    questions : mapping of str to str, optional
        What experiments ask, by name.

    Returns
    -------
    page : str
    """
    finished, others = find_runs(root)
    figures = (f"figure-{k}" for k in count())
    sections = []
    for name in sorted({run.experiment for run in finished}):
        own = [run for run in finished if run.experiment == name]
        asked = f"<p>{escape((questions or {}).get(name, ''))}</p>"
        shown = _sweeps(own, root, figures) + _table(own, root, viewed, figures)
        sections.append(f"<h2>{escape(name)}</h2>{asked}{shown}")
    sections += [
        f'<p class="dim">{escape(str(folder.relative_to(root)))} was not finished</p>'
        for folder in others
    ]
    content = "\n".join(sections) or "<p>There are no runs here yet.</p>"
    title = escape(root.resolve().name)
    return (
        f'<!doctype html><html lang="en"><head>{PAGE_HEAD}<title>{title}</title>'
        f"<style>{_STYLE}</style></head><body><h1>{title}</h1>{content}</body></html>\n"
    )


def _table(
    runs: Sequence[FinishedRun],
    root: Path,
    viewed: Callable[[str], str],
    names: Iterator[str],
) -> str:
    """One row a run: headlines of its best method, above those of the mean pose."""
    from silpose.evaluation import headlines

    titles, values = headlines(
        {f"{k} {method}": own for k, run in enumerate(runs) for method, own in _shown(run).items()}
    )
    by_name = {row[0]: row[1:] for row in values}
    settings = differing([parsed(run.config) for run in runs])
    last = "best" if any(run.metrics for run in runs) else "found"
    words = ["figure", "run", "data", "differs in", last]
    if not settings[0]:
        words.remove("differs in")
    head = "".join(f'<th class="word">{word}</th>' for word in words)
    head += "".join(f"<th>{escape(title)}</th>" for title in titles[1:])
    rows = []
    for k, run in enumerate(runs):
        methods = list(_shown(run))
        cells = {
            "figure": _figure(run, root, next(names)),
            "run": _link(run, root, viewed),
            "data": escape(run.dataset),
            "differs in": _in_words(settings[k]),
            last: _above(methods) or escape(found_in_words(run)),
        }
        row = "".join(_cell(word, cells[word], _CLASSES.get(word, "word")) for word in words)
        numbers = zip(*(by_name[f"{k} {method}"] for method in methods), strict=True)
        row += "".join(map(_cell, titles[1:], map(_above, numbers)))
        rows.append(f"<tr>{row}</tr>")
    return f"<table><tr>{head}</tr>{''.join(rows)}</table>"


def _cell(title: str, content: str, kind: str = "") -> str:
    of_kind = f' class="{kind}"' if kind else ""
    return f'<td{of_kind} data-title="{escape(title)}">{content}</td>'


def _shown(run: FinishedRun) -> Metrics:
    return {m: run.metrics[m] for m in (run.best, "mean_pose") if run.best and m in run.metrics}


def _above(words: Sequence[str]) -> str:
    """Set the first word above the others, which are dim."""
    first, *others = words or [""]
    below = "".join(f'<br><span class="dim">{escape(word)}</span>' for word in others)
    return f"<span>{escape(first)}{below}</span>" if first or below else ""


def _in_words(settings: Mapping[str, object]) -> str:
    """Write the settings in which a run differs from the others, a line each."""
    lines = [
        f"{escape(name)}=<wbr>{escape(typed(value))}"
        for name, value in settings.items()
        if value is not None
    ]
    if len(lines) > _MOST:
        lines[_MOST:] = [f"and {len(lines) - _MOST} more"]
    return f"<span>{'<br>'.join(lines)}</span>" if lines else ""


def _figure(run: FinishedRun, root: Path, name: str) -> str:
    """Write the small figure of a run."""
    file = run.folder / f"{run.experiment}.png"
    return _enlarged(file, root, name, f"figure of {run.folder.name}") if file.is_file() else ""


def _sweeps(runs: Sequence[FinishedRun], root: Path, names: Iterator[str]) -> str:
    """Write the figures of the sweeps that the runs belong to, each under its name."""
    figures = dict.fromkeys(run.folder.parent / FIGURE for run in runs)
    return "".join(
        f'<div class="sweep">Sweep {escape(file.parent.name)}'
        f"{_enlarged(file, root, next(names), f'figure of the sweep {file.parent.name}')}</div>"
        for file in figures
        if file.is_relative_to(root) and file.is_file()
    )


def _enlarged(file: Path, root: Path, name: str, words: str) -> str:
    """Write a small picture that becomes large on a click."""
    picture = f'<img loading="lazy" src="{_below(root, file)}" alt="{escape(words)}">'
    return (
        f'<button popovertarget="{name}">{picture}</button>'
        f'<div popover id="{name}"><button popovertarget="{name}">{picture}</button></div>'
    )


def _name(run: FinishedRun) -> str:
    """Name of a run; in a sweep below the sweep's."""
    above = run.folder.parent
    return f"{above.name}/{run.folder.name}" if (above / SWEEP).is_file() else run.folder.name


def _link(run: FinishedRun, root: Path, viewed: Callable[[str], str]) -> str:
    name = escape(_name(run))
    if not run.recording.is_file():
        return name
    return f'<a href="{escape(viewed(_below(root, run.recording)))}">{name}</a>'


def _below(root: Path, file: Path) -> str:
    return quote(file.relative_to(root).as_posix())
