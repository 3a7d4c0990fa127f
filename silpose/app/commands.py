"""Commands for what runs leave behind: ``silpose compare``, ``picture`` and more."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

TOOLS = ("compare", "picture", "film", "serve", "repair")


def run_tool(arguments: Sequence[str]) -> None:
    """Run the command that the first argument names."""
    given = _parser().parse_args(list(arguments))
    given.call(given)


def _compare(given: argparse.Namespace) -> None:
    from silpose.app.summary import rerun_command, shorten_path
    from silpose.recording import compare
    from silpose.recording.runs.finished_run import load_run

    compare([load_run(folder) for folder in given.runs], given.output, given.method)
    print(f"Open it:  {rerun_command()} {shorten_path(given.output)}")


def _picture(given: argparse.Namespace) -> None:
    from silpose.recording import picture

    picture(_recording(given.run), given.frame, given.output, given.view, given.width)


def _film(given: argparse.Namespace) -> None:
    from silpose.recording import film

    frames = range(given.first, given.last + 1, given.every)
    rate = given.rate / given.every
    film(_recording(given.run), frames, given.output, given.view, given.width, rate)


def _serve(given: argparse.Namespace) -> None:
    from silpose.recording import serve

    serve(given.folder, given.port)


def _repair(given: argparse.Namespace) -> None:
    from silpose.app.summary import rerun_command, shorten_path
    from silpose.recording import repair

    print(f"Open it:  {rerun_command()} {shorten_path(repair(given.run))}")


def _recording(run: Path) -> Path:
    return run / "run.rrd" if run.is_dir() else run


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="silpose")
    tools = parser.add_subparsers(required=True)

    tool = tools.add_parser("compare", help="runs side by side on one timeline, in one recording")
    tool.add_argument("runs", nargs="+", type=Path, metavar="RUN", help="folders of runs")
    tool.add_argument("-o", "--output", type=Path, default=Path("comparison.rrd"))
    tool.add_argument("--method", help="whose errors are drawn")
    tool.set_defaults(call=_compare)

    tool = tools.add_parser("picture", help="a frame of a recording as PNG, without a screen")
    _what_to_paint(tool, width=1600)
    tool.add_argument("--frame", type=int, default=0)
    tool.add_argument("-o", "--output", type=Path, default=Path("picture.png"))
    tool.set_defaults(call=_picture)

    tool = tools.add_parser("film", help="a stretch of a recording as GIF or MP4")
    _what_to_paint(tool, width=900)
    tool.add_argument("--first", type=int, default=0, help="frame")
    tool.add_argument("--last", type=int, default=59, help="frame")
    tool.add_argument("--every", type=int, default=1, help="so many frames apart")
    tool.add_argument("--rate", type=float, default=15, help="of the recording, frames a second")
    tool.add_argument("-o", "--output", type=Path, default=Path("film.gif"))
    tool.set_defaults(call=_film)

    tool = tools.add_parser("serve", help="a folder of runs in the browser, on this machine only")
    tool.add_argument("folder", nargs="?", type=Path, default=Path("recordings"), metavar="FOLDER")
    tool.add_argument("--port", type=int, default=9090)
    tool.set_defaults(call=_serve)

    tool = tools.add_parser("repair", help="salvage a recording that was cut off")
    tool.add_argument("run", type=Path, metavar="RUN", help="a run's folder, or a recording")
    tool.set_defaults(call=_repair)
    return parser


def _what_to_paint(tool: argparse.ArgumentParser, width: int) -> None:
    tool.add_argument("run", type=Path, metavar="RUN", help="a run's folder, or a recording")
    tool.add_argument("--view", help="beginning of a view's title; else the whole window")
    tool.add_argument("--width", type=int, default=width, help="pixels")
