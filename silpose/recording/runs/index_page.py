"""A page that lists a folder's runs, each with its figure, headlines and recording."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from html import escape
from pathlib import Path
from urllib.parse import quote

from silpose.core.atomic_files import unfinished_pattern
from silpose.core.errors import InputError
from silpose.recording.runs.finished_run import FinishedRun, load_run

_STYLE = """
body { font: 15px system-ui, sans-serif; margin: 2em auto; max-width: 70em; padding: 0 1em;
       color: #ddd; background: #16181c; }
a { color: #ff9632; } h2 { margin-top: 2em; } .dim { color: #888; }
table { border-collapse: collapse; width: 100%; }
th { text-align: right; font-weight: normal; color: #888; padding: .4em .6em; }
td { text-align: right; vertical-align: top; border-top: 1px solid #333; padding: .4em .6em; }
th, td { font-variant-numeric: tabular-nums; }
td.word, th.word { text-align: left; }
img { height: 5em; border-radius: 4px; display: block; }
"""


def index_page(root: Path, viewed: Callable[[str], str]) -> str:
    """Write the page as HTML, the latest run first.

    Parameters
    ----------
    root : Path
        Folder whose runs are listed, at any depth.
    viewed : callable
        From a recording's path below the root to the address that shows it.

    Returns
    -------
    page : str
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
    """Finished runs, the latest first, and folders of runs that were cut off."""
    finished, others = [], []
    for file in root.rglob("metrics.json"):
        try:
            finished.append((file.stat().st_mtime, load_run(file.parent)))
        except InputError:
            others.append(file.parent)
    others += [file.parent for file in root.rglob(unfinished_pattern(Path("run.rrd")))]
    return [run for _, run in sorted(finished, key=lambda each: -each[0])], sorted(set(others))


def _table(runs: Sequence[FinishedRun], root: Path, viewed: Callable[[str], str]) -> str:
    """One row a run: headlines of the method that it shows, above those of the mean pose."""
    results = {f"{k} {m}": own for k, run in enumerate(runs) for m, own in _shown(run).items()}
    from silpose.evaluation import headlines  # loads scikit-learn: only once there is a run

    titles, values = headlines(results)
    by_name = {row[0]: row[1:] for row in values}
    head = "".join(f'<th class="word">{word}</th>' for word in ("", "run", "data", "method"))
    head += "".join(f"<th>{escape(title)}</th>" for title in titles[1:])
    rows = []
    for k, run in enumerate(runs):
        methods = list(_shown(run))
        words = (_figure(run, root), _link(run, root, viewed), escape(run.dataset), _above(methods))
        numbers = map(_above, zip(*(by_name[f"{k} {m}"] for m in methods), strict=True))
        cells = "".join(f'<td class="word">{word}</td>' for word in words)
        rows.append(f"<tr>{cells}{''.join(f'<td>{n}</td>' for n in numbers)}</tr>")
    return f"<table><tr>{head}</tr>{''.join(rows)}</table>"


def _shown(run: FinishedRun) -> dict[str, Mapping[str, float]]:
    return {m: run.metrics[m] for m in (run.shown, "mean_pose") if m in run.metrics}


def _above(words: Sequence[str]) -> str:
    """Set the first word above the others, which are dim."""
    first, *others = words or [""]
    return escape(first) + "".join(
        f'<br><span class="dim">{escape(word)}</span>' for word in others
    )


def _figure(run: FinishedRun, root: Path) -> str:
    file = run.folder / f"{run.experiment}.png"
    source = _below(root, file)
    picture = f'<a href="{source}"><img src="{source}" alt="figure"></a>'
    return picture if file.is_file() else ""


def _link(run: FinishedRun, root: Path, viewed: Callable[[str], str]) -> str:
    name = escape(run.folder.name)
    if not run.recording.is_file():
        return name
    return f'<a href="{escape(viewed(_below(root, run.recording)))}">{name}</a>'


def _below(root: Path, file: Path) -> str:
    return quote(file.relative_to(root).as_posix())
