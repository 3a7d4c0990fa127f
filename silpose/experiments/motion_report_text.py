"""The text of `motion_report`: a block for each skeleton, a line for each take."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping, Sequence, Sized
from itertools import starmap
from pathlib import Path

from silpose.motion import CaptureReport
from silpose.recording.captions import facts_in_markdown, table_in_markdown

_WIDTH, _INDENT = 100, 12
_TITLES = ("take", "seconds", "frames/s", "m/unit", "m/s", "strides/s", "turns left", "doubts")
_ENDS = ("head_top", "left_hand", "left_toes")


def report_in_words(
    root: Path, reports: Mapping[str, CaptureReport], refused: Mapping[str, str]
) -> str:
    """Write what was understood of files, those that were understood alike together.

    Parameters
    ----------
    root : Path
        What was read.
    reports : mapping of str to CaptureReport
        By file.
    refused : mapping of str to str
        Reasons by file.
    """
    parts = [_head(root, reports, refused)]
    for own in _blocks(reports):
        parts.append("\n".join([_title(own), *starmap(_item, _facts(own)), "", *_takes(own)]))
        if doubts := list(starmap(_item, _doubts(own))):
            parts[-1] += "\n\n" + "\n".join(doubts)
    if refused:
        parts.append("\n".join(starmap(_item, _refusals(refused))))
    return "\n\n".join(parts)


def report_in_markdown(
    root: Path, reports: Mapping[str, CaptureReport], refused: Mapping[str, str]
) -> str:
    """Write the same for a recording, whose lines are as long as its window is wide."""
    parts = [f"`{_head(root, reports, refused)}`"]
    for own in _blocks(reports):
        parts += [
            f"### `{_title(own)}`",
            table_in_markdown([row[:3] + row[4:] for row in _rows(own)]),
        ]
        parts += [facts_in_markdown([*_doubts(own), *_facts(own)])]
    parts += [facts_in_markdown(_refusals(refused))] if refused else []
    return "\n\n".join(parts)


def report_table(
    reports: Mapping[str, CaptureReport], refused: Mapping[str, str]
) -> list[list[object]]:
    """Lay the reports out as a table, one row per file, titles first."""
    table: list[list[object]] = [
        ["file", "format", "seconds", "source_rate", "up", "mirrored", "rest",
         "rest_uncertainty_deg", "metres_per_unit", "speed_m_s", "strides_per_second",
         "heading_change_deg", "notes"]
    ]  # fmt: skip
    for file, r in reports.items():
        strides = "" if r.strides_per_second is None else f"{r.strides_per_second:.3g}"
        numbers = (r.metres_per_unit, r.speed)
        table.append(
            [file, r.format, f"{r.seconds:.3f}", f"{r.source_rate:g}", r.up, r.mirrored, r.rest,
             f"{r.rest_uncertainty:.1f}", *(f"{v:.4g}" for v in numbers), strides,
             f"{r.heading_change:.1f}", "; ".join(r.notes)]
        )  # fmt: skip
    return table + [[file, *[""] * 11, f"refused: {reason}"] for file, reason in refused.items()]


def _understood(r: CaptureReport) -> tuple[object, ...]:
    """List what takes of one block have in common."""
    joints = tuple((ours, theirs, r.how[ours]) for ours, theirs in r.joints.items())
    return (r.format, joints, r.rest, r.rest_uncertainty, r.up, r.turned, r.mirrored, r.facing,
            r.unit, r.assumed)  # fmt: skip


def _head(root: Path, reports: Sized, refused: Sized) -> str:
    counted = f"{len(reports) + len(refused)} files, {len(reports)} understood"
    return f"{root}: {counted}" if len(reports) + len(refused) > 1 else str(root)


def _blocks(reports: Mapping[str, CaptureReport]) -> Iterable[dict[str, CaptureReport]]:
    """Group takes that were understood alike."""
    blocks: dict[tuple[object, ...], dict[str, CaptureReport]] = {}
    for file, report in reports.items():
        blocks.setdefault(_understood(report), {})[file] = report
    return blocks.values()


def _title(reports: Mapping[str, CaptureReport]) -> str:
    (first, r), *others = reports.items()
    return f"{first} ({r.format})" + (f" and {len(others)} more" if others else "")


def _facts(reports: Mapping[str, CaptureReport]) -> list[tuple[str, str]]:
    """Say what takes that were understood alike have in common."""
    r = next(iter(reports.values()))
    off = f"; the torso may be {r.rest_uncertainty:.0f}° off" if r.rest_uncertainty else ""
    axes = f"{r.up} points up" + (", turned upright" if r.turned else "")
    mirrored = "; mirrored, as motion.mirror says" if r.mirrored else ""
    return [
        ("joints", _joints(r)),
        ("rest pose", r.rest + off),
        ("axes", f"{axes}; facing by {r.facing}{mirrored}"),
        ("size", _size(list(reports.values()))),
        *(("assumed", text) for text in r.assumed if r.rest not in text),
    ]


def _doubts(reports: Mapping[str, CaptureReport]) -> list[tuple[str, str]]:
    """Name for each doubt the first take that has it, and count the others."""
    noted: dict[str, list[str]] = {}
    for file, report in reports.items():
        for note in report.notes:
            noted.setdefault(note, []).append(file)
    more = {note: f" and {len(files) - 1} more" * (len(files) > 1) for note, files in noted.items()}
    return [("doubt", f"{files[0]}{more[note]}: {note}") for note, files in noted.items()]


def _refusals(refused: Mapping[str, str]) -> list[tuple[str, str]]:
    return [("refused", f"{file}: {reason}") for file, reason in refused.items()]


def _joints(r: CaptureReport) -> str:
    """Name the joints, left and right ones together."""
    words = []
    for ours, theirs in r.joints.items():
        side, _, part = ours.partition("_")
        if side == "right":
            continue
        other = r.joints.get(f"right_{part}") if side == "left" else None
        names = " / ".join(_name(name) for name in (theirs, other) if name)
        hows = dict.fromkeys(r.how[o] for o in (ours, f"right_{part}") if o in r.how)
        how = " or ".join(h for h in hows if h != "by name" and ours not in _ENDS)
        words.append(f"{part if other else ours} {names}{f' ({how})' if how else ''}")
    return "; ".join(words)


def _name(theirs: str) -> str:
    name, slash, end = theirs.rpartition("/end")
    return f"end of {name}" if slash and (not end or end.isdigit()) else theirs


def _size(reports: Sequence[CaptureReport]) -> str:
    legs, known = [r.leg_length for r in reports], reports[0].unit
    if known:
        return f"legs of {_range([known * leg for leg in legs])} m, as the format says its unit"
    scales = _range([r.metres_per_unit for r in reports])
    return f"legs of {_range(legs)} units, which are taken as {scales} m each"


def _range(values: Sequence[float]) -> str:
    low, high = f"{min(values):.3g}", f"{max(values):.3g}"
    return low if low == high else f"{low} to {high}"


def _rows(reports: Mapping[str, CaptureReport]) -> list[tuple[str, ...]]:
    rows: list[tuple[str, ...]] = [_TITLES]
    for file, r in reports.items():
        strides = "-" if r.strides_per_second is None else f"{r.strides_per_second:.2f}"
        rows.append(
            (file, f"{r.seconds:.1f}", f"{r.source_rate:g}", f"{r.metres_per_unit:.4g}",
             f"{r.speed:.2f}", strides, f"{r.heading_change:+.0f}°", str(len(r.notes) or "-"))
        )  # fmt: skip
    return rows


def _takes(reports: Mapping[str, CaptureReport]) -> list[str]:
    rows = _rows(reports)
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return ["  " + _row(row, widths) for row in rows]


def _row(cells: Iterable[str], widths: Sequence[int]) -> str:
    first, *rest = zip(cells, widths, strict=True)
    return "  ".join([first[0].ljust(first[1]), *(cell.rjust(width) for cell, width in rest)])


def _item(title: str, text: str) -> str:
    return textwrap.fill(
        text,
        _WIDTH,
        initial_indent=f"  {title}".ljust(_INDENT + 2),
        subsequent_indent=" " * (_INDENT + 2),
        break_long_words=False,
        break_on_hyphens=False,
    )
