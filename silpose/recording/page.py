"""The page that lists a folder's runs, each with its figure, its headlines and its recording."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from html import escape
from pathlib import Path
from urllib.parse import quote

from silpose.errors import InputError
from silpose.files import partial
from silpose.headlines import headlines
from silpose.run import FinishedRun, load_run

_STYLE = """
body { font: 15px system-ui, sans-serif; margin: 2em auto; max-width: 70em; padding: 0 1em;
       color: #ddd; background: #16181c; }
a { color: #ff9632; } h2 { margin-top: 2em; } .dim { color: #888; }
table { border-collapse: collapse; width: 100%; }
th { text-align: right; font-weight: normal; color: #888; }
td { text-align: right; border-top: 1px solid #333; padding: .4em .6em; }
th, td { font-variant-numeric: tabular-nums; }
td.word, th.word { text-align: left; }
img { height: 5em; border-radius: 4px; display: block; }
"""


def page(root: Path, viewed: Callable[[str], str]) -> str:
    """Write the page, the latest run first.

    Parameters
    ----------
    root : Path
        All runs below it are listed.
    viewed : callable
        From a recording's path below the root to the address that shows it.
    """
    finished, others = _runs(root)
    experiments = sorted({run.experiment for run in finished})
    sections = [
        f"<h2>{escape(name)}</h2>"
        + _table([run for run in finished if run.experiment == name], root, viewed)
        for name in experiments
    ]
    sections += [
        f'<p class="dim">{escape(str(folder.relative_to(root)))} was not finished</p>'
        for folder in others
    ]
    content = "\n".join(sections) or "<p>There are no runs here yet.</p>"
    return (
        f'<!doctype html><html lang="en"><meta charset="utf-8"><title>{escape(root.name)}</title>'
        f"<style>{_STYLE}</style><h1>{escape(root.name)}</h1>{content}</html>\n"
    )


def _runs(root: Path) -> tuple[list[FinishedRun], list[Path]]:
    """Find finished runs, the latest first, and folders of runs that were cut off."""
    finished, others = [], []
    for file in root.rglob("metrics.json"):
        try:
            finished.append((file.stat().st_mtime, load_run(file.parent)))
        except InputError:
            others.append(file.parent)
    hidden = partial(Path("run.rrd")).name
    others += [file.parent for file in root.rglob(hidden)]
    return [run for _, run in sorted(finished, key=lambda each: -each[0])], sorted(set(others))


def _table(runs: Sequence[FinishedRun], root: Path, viewed: Callable[[str], str]) -> str:
    """Write one row a run: the headlines of the method that it shows."""
    titles, _ = headlines({f"{k}": _values(run) for k, run in enumerate(runs)})
    words = ["", "run", "data", "method"]
    head = "".join(f'<th class="word">{word}</th>' for word in words)
    head += "".join(f"<th>{escape(title)}</th>" for title in titles[1:])
    rows = []
    for run in runs:
        own, values = headlines({run.shown: _values(run)})
        told = dict(zip(own, values[0], strict=True))
        where = quote(run.folder.relative_to(root).as_posix())
        name = escape(run.folder.name)
        if run.recording.is_file():
            name = f'<a href="{viewed(f"{where}/{run.recording.name}")}">{name}</a>'
        figure = ""
        if (run.folder / f"{run.experiment}.png").is_file():
            source = f"{where}/{run.experiment}.png"
            figure = f'<a href="{source}"><img src="{source}" alt="figure"></a>'
        first = (figure, name, escape(run.dataset), escape(run.shown))
        cells = "".join(f'<td class="word">{cell}</td>' for cell in first)
        cells += "".join(f"<td>{escape(told.get(title, ''))}</td>" for title in titles[1:])
        rows.append(f"<tr>{cells}</tr>")
    return f"<table><tr>{head}</tr>{''.join(rows)}</table>"


def _values(run: FinishedRun) -> dict[str, float]:
    return run.metrics.get(run.shown, {})
