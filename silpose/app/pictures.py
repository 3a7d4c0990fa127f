"""The verbs that paint a recording: ``silpose picture`` and ``silpose film``."""

from __future__ import annotations

import argparse
import re
from pathlib import Path

from silpose.app.paths import shorten_path
from silpose.core.errors import InputError
from silpose.core.stage_lines import stage_lines
from silpose.core.stages import stage

_LONGEST = 60  # frames of a film if nothing else is said


def picture_options(verb: argparse.ArgumentParser) -> None:
    """Add what ``picture`` is given."""
    _painted_options(verb, width=1600)
    verb.add_argument("--frame", type=int, default=0, help="the first is 0, as by default")
    verb.add_argument("-o", "--output", type=Path, help="PNG; named after run and frame if not set")


def paint_picture(given: argparse.Namespace) -> None:
    """Write a picture, and say where it is."""
    _at_least_one("width", given.width)
    recording = recording_of(given.run)
    output = given.output or _named(recording, f"frame_{given.frame}", given.view, ".png")
    with stage_lines(), stage("painting"):
        from silpose.recording import picture  # loads Rerun, which takes a second or more

        picture(recording, given.frame, output, given.view, given.width)
    print(f"Wrote {shorten_path(output)}")


def film_options(verb: argparse.ArgumentParser) -> None:
    """Add what ``film`` is given."""
    _painted_options(verb, width=900)
    verb.add_argument("--first", type=int, default=0, help="frame; the first is 0, as by default")
    longest = f"frame; {_LONGEST - 1} after the first if not set, or the last that there is"
    verb.add_argument("--last", type=int, help=longest)
    verb.add_argument("--every", type=int, default=1, help="so many frames apart")
    verb.add_argument("--rate", type=float, default=15, help="of the recording, frames per second")
    plain = "mask, pose on it and pose in 3D side by side, without the viewer"
    verb.add_argument("--plain", action="store_true", help=plain)
    named = "GIF or MP4; a GIF named after run and frames if not set"
    verb.add_argument("-o", "--output", type=Path, help=named)


def paint_film(given: argparse.Namespace) -> None:
    """Write a film, and say where it is."""
    for name in ("width", "every"):
        _at_least_one(name, getattr(given, name))
    if given.rate <= 0:
        raise InputError(f"--rate must be positive, not {given.rate:g}")
    recording = recording_of(given.run)
    rate = given.rate / given.every
    with stage_lines(), stage("painting"):
        from silpose.recording import film, frames_of  # as above

        last = given.last
        if last is None:
            last = min(given.first + _LONGEST - 1, max(frames_of(recording), default=given.first))
            last = max(last, given.first)  # a first frame that is not there is named as such
        if last < given.first:
            raise InputError(f"--last {last} comes before --first {given.first}")
        frames = range(given.first, last + 1, given.every)
        output = given.output or _named(recording, f"{given.first}-{last}", given.view, ".gif")
        film(recording, frames, output, given.view, given.width, rate, given.plain)
    print(f"Wrote {shorten_path(output)}: {len(frames)} frames")


def recording_of(run: Path) -> Path:
    """Path of the recording that a run's folder holds; of a recording, its own."""
    return run / "run.rrd" if run.is_dir() else run


def _painted_options(verb: argparse.ArgumentParser, width: int) -> None:
    verb.add_argument("run", type=Path, metavar="RUN", help="a run's folder, or a recording")
    verb.add_argument("--view", help="beginning of a view's title; else the whole window")
    verb.add_argument("--width", type=int, default=width, help=f"pixels, {width} by default")


def _at_least_one(name: str, value: int) -> None:
    if value < 1:
        raise InputError(f"--{name} must be at least 1, not {value}")


def _named(recording: Path, frames: str, view: str | None, ending: str) -> Path:
    """Name a file after what is in it, so that pictures do not overwrite each other."""
    whole = recording.absolute()
    names = [*whole.parts[-3:-1], ""] if whole.name == "run.rrd" else [whole.stem, ""]
    if view:
        names[-1] = re.sub(r"\W+", "_", view).strip("_")
    return Path("_".join([*filter(None, names), frames]) + ending)
