"""A gait report as rows of ``gait.csv`` and as a page, ``gait.html``, that needs no other file."""

from __future__ import annotations

import io
from collections.abc import Sequence
from html import escape
from pathlib import Path

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from silpose.core.atomic_files import writing
from silpose.core.csv_text import csv_text
from silpose.evaluation.gait import MOVES, PERCENT, GaitReport
from silpose.recording import palette
from silpose.recording.figure_style import DIM, INK, styled
from silpose.recording.page_style import PAGE_HEAD, PAGE_STYLE

TITLES = (
    "name", "side", "percent", "value", "deviation", "unit", "strides", "confidence", "frames",
    "reason",
)  # fmt: skip

_SIDES = {side: palette.hexed(palette.shade(palette.ESTIMATED, side)) for side in ("left", "right")}
_STYLE = (
    PAGE_STYLE
    + """
body { max-width: 62em; } svg { width: 100%; height: auto; }
th:first-child, td:first-child { text-align: left; }
.wide { overflow-x: auto; }
@media screen and (max-width: 600px) {
  th, td { padding: .3em; } td + td { white-space: nowrap; } .wide svg { width: 44em; }
}
"""
)


def gait_rows(report: GaitReport) -> list[tuple[object, ...]]:
    """Tables of ``gait.csv`` as rows, that of titles first.

    Parameters
    ----------
    report : GaitReport

    Returns
    -------
    rows : list of tuple
        Parameters; then hip, knee and ankle at every percent of the gait cycle (``hip_flexion``
        and so on); then the time of each ``strike`` and ``off``. Frames are written as
        ``12-45 46-80``, a range a stride; what is not known is empty, with its reason.
    """
    rows: list[tuple[object, ...]] = [TITLES]
    for p in report.parameters:
        rows.append(
            (p.name, p.side, "", _number(p.value), _number(p.deviation), p.unit, p.strides,
             _number(p.confidence), _ranges(p.frames), p.reason)
        )  # fmt: skip
    for c in report.curves:
        name = f"{c.joint}_{MOVES[c.joint][0]}"
        rows += [
            (name, c.side, f"{percent:.0f}", _number(mean), _number(band), "deg", c.strides,
             _number(c.confidence), _ranges(c.frames), c.reason)
            for percent, mean, band in zip(PERCENT, c.mean, c.band, strict=True)
        ]  # fmt: skip
    for event in report.events:
        name = "strike" if event.strike else "off"
        rows.append((name, event.side, "", _number(event.time), "", "s", "", "", "", ""))
    return rows


def gait_page(report: GaitReport, title: str = "Gait") -> str:
    """Write the report as HTML, with its figures inside; light or dark as the reader's system.

    Parameters
    ----------
    report : GaitReport
    title : str, default="Gait"
        Such as the name of the take.
    """
    counted = len(report.counted)
    way = {"none": "No steps", "forward": "Walks forward", "backward": "Walks backward"}
    notes = "".join(f"<li>{escape(note)}</li>" for note in report.notes)
    return (
        f'<!doctype html><html lang="en">{PAGE_HEAD}<title>{escape(title)}</title>'
        f"<style>{_STYLE}</style>"
        f"<h1>{escape(title)}</h1><p>{way[report.direction]}: {counted} strides.</p>"
        f"<ul>{notes}</ul>{_table(report)}"
        f'<div class="wide" tabindex="0">{_svg(_figure(report))}</div>'
        '<p class="dim">Mean and standard deviation over the strides. Symmetry is the difference '
        "of left and right over their mean, positive if the left is larger. Angles are those in "
        "the plane of walking; the gait cycle begins with the foot's strike.</p></html>\n"
    )


def write_gait(report: GaitReport, folder: str | Path, title: str = "Gait") -> tuple[Path, Path]:
    """Write ``gait.csv`` and ``gait.html``, each complete or not at all.

    Parameters
    ----------
    report : GaitReport
    folder : path
        Exists.
    title : str, default="Gait"
        Heading of the page.

    Returns
    -------
    table, page : Path

    Raises
    ------
    InputError
        If nothing can be written there.
    """
    folder = Path(folder)
    texts = {"gait.csv": csv_text(gait_rows(report)), "gait.html": gait_page(report, title)}
    for name, text in texts.items():
        with writing(folder / name) as file:
            file.write_text(text, encoding="utf-8")
    return folder / "gait.csv", folder / "gait.html"


def _number(value: float) -> str:
    return f"{value:.4f}" if np.isfinite(value) else ""


def _ranges(frames: Sequence[tuple[int, int]]) -> str:
    return " ".join(f"{first}-{last}" for first, last in frames)


def _table(report: GaitReport) -> str:
    sides = ("both", "left", "right")
    head = "".join(f"<th>{word}</th>" for word in ("", *sides, "strides", "confidence", "frames"))
    rows = []
    for name in dict.fromkeys(p.name for p in report.parameters):
        by_side = {p.side: p for p in report.parameters if p.name == name}
        whole = by_side["both"]
        cells = [f"{escape(name.replace('_', ' '))} ({escape(whole.unit)})"]
        for side in sides:
            p = by_side.get(side)
            if p is None or not np.isfinite(p.value):
                cells.append("" if p is None else f'<span title="{escape(p.reason)}">–</span>')
                continue
            spread = f" ± {p.deviation:.2f}" if np.isfinite(p.deviation) else ""
            cells.append(f'{p.value:.2f}<span class="dim">{spread}</span>')
        sure = f"{whole.confidence:.2f}" if np.isfinite(whole.confidence) else "–"
        span = f"{whole.frames[0][0]} to {max(b for _, b in whole.frames)}" if whole.frames else "–"
        cells += [str(whole.strides), sure, span]
        rows.append("<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>")
    reasons = dict.fromkeys(p.reason for p in report.parameters if p.reason)
    missing = "".join(f"<p>No value: {escape(reason)}.</p>" for reason in reasons)
    table = f"<table><tr>{head}</tr>{''.join(rows)}</table>"
    return f'<div class="wide" tabindex="0">{table}</div>{missing}'


@styled
def _figure(report: GaitReport) -> Figure:
    figure = Figure(figsize=(11, 5.6), layout="constrained")
    grid = figure.add_gridspec(2, len(MOVES), height_ratios=(3, 1))
    for k, joint in enumerate(MOVES):
        axes = figure.add_subplot(grid[0, k])
        _draw_angle(axes, report, joint)
    handles, labels = axes.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=2)
    _draw_stances(figure.add_subplot(grid[1, :]), report)
    return figure


def _draw_angle(axes: Axes, report: GaitReport, joint: str) -> None:
    """Draw the mean and the band of both sides, and where the foot leaves the ground."""
    positive, negative = MOVES[joint]
    for curve in report.curves:
        if curve.joint != joint:
            continue
        colour, dashes = _SIDES[curve.side], "-" if curve.side == "left" else "--"
        axes.plot(PERCENT, curve.mean, dashes, color=colour, label=f"{curve.side} foot's cycle")
        low, high = curve.mean - curve.band, curve.mean + curve.band
        axes.fill_between(PERCENT, low, high, color=colour, alpha=0.2, lw=0)
        stance = report["stance", curve.side].value
        if np.isfinite(stance):
            axes.axvline(stance, color=colour, ls=dashes, lw=0.8)
    axes.axhline(0.0, color=INK, lw=0.5)
    axes.set(xlim=(0, 100), xlabel="gait cycle, %", title=joint)
    axes.set_ylabel(f"{negative} (-), {positive} (+), degrees")


def _draw_stances(axes: Axes, report: GaitReport) -> None:
    """Draw a bar for each time that a foot is on the ground; strides that do not count are pale."""
    for row, side in enumerate(reversed(_SIDES)):
        for stride in report.strides:
            if stride.side == side and np.isfinite(stride.off):
                alpha = 0.25 if stride.fault else 1.0
                axes.barh(
                    row, stride.off - stride.start, left=stride.start, height=0.6,
                    color=_SIDES[side], alpha=alpha,
                )  # fmt: skip
    axes.set(yticks=(0, 1), ylim=(-0.6, 1.6), xlabel="time, s", title="feet on the ground")
    axes.set_yticklabels(list(reversed(_SIDES)))


def _svg(figure: Figure) -> str:
    """Figure as an element of the page, whose axes and text have the page's colour."""
    text = io.StringIO()
    with rc_context({"svg.fonttype": "none", "svg.hashsalt": "gait"}):
        figure.savefig(text, format="svg", transparent=True, metadata={"Date": None})
    svg = text.getvalue()
    for colour in (INK, DIM):
        svg = svg.replace(colour, "currentColor")
    return svg[svg.index("<svg") :]
