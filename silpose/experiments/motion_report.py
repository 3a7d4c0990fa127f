"""What is understood of one's own motion capture files."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from silpose.core.csv_text import csv_text
from silpose.core.errors import InputError
from silpose.core.parameters import POSITIVE_INTEGER, check_values
from silpose.core.pose_space import ANGLES
from silpose.core.progress import bar
from silpose.core.stages import timed
from silpose.experiments.motion_report_figure import motion_figure
from silpose.experiments.motion_report_text import (
    report_in_markdown,
    report_in_words,
    report_table,
)
from silpose.experiments.setup import Components, renderer_of
from silpose.motion import CapturedTake, MotionFolder
from silpose.recording import Recording, Result, record_motion


def motion_report(components: Components, *, shown: int = 12) -> Result:
    """Show for each motion capture file its joints, rest pose, axes, size and speed as understood.

    The report is printed and kept as ``report.txt``, and as the table ``takes.csv``; the first take
    is recorded.

    Parameters
    ----------
    components : Components
        Their motion is read from files, ``motion=bvh`` or ``motion=amass``.
    shown : int, default=12
        Number of takes in the figure.
    """
    check_values("shown", POSITIVE_INTEGER, shown)
    folder = renderer_of(components, "motion_report").source
    if not isinstance(folder, MotionFolder):
        raise InputError("motion_report shows files: give them, 'silpose motion PATH'")
    takes, refused = _read(folder)
    root = Path(folder.root)
    reports = {file: take.report for file, take in takes.items()}
    text = report_in_words(root, reports, refused)
    if not takes:
        return Result(root.name, {}, report=text)
    told = report_in_markdown(root, reports, refused)
    first, take = next(iter(takes.items()))
    record = partial(
        record_motion,
        x=ANGLES.from_angles(take.angles),
        root=take.root_position,
        frames_per_second=take.report.frames_per_second,
    )
    return Result(
        root.name,
        {},
        figure=motion_figure(dict(list(takes.items())[:shown])),
        recording=Recording(f"Shown: `{first}`\n\n{told}", record),
        tables={"takes.csv": csv_text(report_table(reports, refused))},
        report=text,
        summary=f"{len(takes)} of {len(takes) + len(refused)} files understood",
    )


@timed("motion")
def _read(folder: MotionFolder) -> tuple[dict[str, CapturedTake], dict[str, str]]:
    """Read all files; those that cannot be used with the reason, which a lone file's error is."""
    takes: dict[str, CapturedTake] = {}
    refused: dict[str, str] = {}
    files = folder.files()
    root = folder.root if folder.root.is_dir() else folder.root.parent
    with bar("motion", len(files)) as advance:
        for file in files:
            name = file.relative_to(root).as_posix()
            try:
                takes[name] = folder.captured(file)
            except InputError as error:
                if folder.strict or len(files) == 1:
                    raise
                refused[name] = str(error).removeprefix(f"{file}: ")
            advance(1)
    return takes, refused
