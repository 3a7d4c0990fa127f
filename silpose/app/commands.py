"""Verbs that are tools: for what runs leave behind, and for settings."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Tool:
    """One verb.

    Attributes
    ----------
    argument : str
        What it is given, in the help text.
    help : str
    options : callable
        Adds arguments and options to the verb's parser.
    run : callable
    """

    argument: str
    help: str
    options: Callable[[argparse.ArgumentParser], None]
    run: Callable[[argparse.Namespace], None]


def run_tool(arguments: Sequence[str]) -> None:
    """Run the verb that the first argument names."""
    parser = argparse.ArgumentParser(prog="silpose")
    verbs = parser.add_subparsers(required=True)
    for name, tool in TOOLS.items():
        of_verb = verbs.add_parser(name, help=tool.help, description=tool.help)
        tool.options(of_verb)
        of_verb.set_defaults(tool=tool)
    given = parser.parse_args(list(arguments))
    given.tool.run(given)


def _recording(run: Path) -> Path:
    return run / "run.rrd" if run.is_dir() else run


def _say_how_to_open(recording: Path) -> None:
    from silpose.app.paths import rerun_command, shorten_path

    print(f"Open it:  {rerun_command()} {shorten_path(recording)}")


def _one_run(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("run", type=Path, metavar="RUN", help="a run's folder, or a recording")


def _compare_options(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("runs", nargs="+", type=Path, metavar="RUN", help="folders of runs")
    verb.add_argument("-o", "--output", type=Path, default=Path("comparison.rrd"))
    verb.add_argument("--method", help="whose errors are drawn")


def _compare(given: argparse.Namespace) -> None:
    from silpose.recording import compare, load_run

    compare([load_run(folder) for folder in given.runs], given.output, given.method)
    _say_how_to_open(given.output)


def _painted_options(verb: argparse.ArgumentParser, width: int) -> None:
    _one_run(verb)
    verb.add_argument("--view", help="beginning of a view's title; else the whole window")
    verb.add_argument("--width", type=int, default=width, help="pixels")


def _picture_options(verb: argparse.ArgumentParser) -> None:
    _painted_options(verb, width=1600)
    verb.add_argument("--frame", type=int, default=0)
    verb.add_argument("-o", "--output", type=Path, default=Path("picture.png"))


def _picture(given: argparse.Namespace) -> None:
    from silpose.recording import picture

    picture(_recording(given.run), given.frame, given.output, given.view, given.width)


def _film_options(verb: argparse.ArgumentParser) -> None:
    _painted_options(verb, width=900)
    verb.add_argument("--first", type=int, default=0, help="frame")
    verb.add_argument("--last", type=int, default=59, help="frame")
    verb.add_argument("--every", type=int, default=1, help="so many frames apart")
    verb.add_argument("--rate", type=float, default=15, help="of the recording, frames per second")
    verb.add_argument("-o", "--output", type=Path, default=Path("film.gif"))


def _film(given: argparse.Namespace) -> None:
    from silpose.recording import film

    frames = range(given.first, given.last + 1, given.every)
    rate = given.rate / given.every
    film(_recording(given.run), frames, given.output, given.view, given.width, rate)


def _root(verb: argparse.ArgumentParser) -> None:
    folder = Path("recordings")
    verb.add_argument("folder", nargs="?", type=Path, default=folder, metavar="FOLDER")


def _serve_options(verb: argparse.ArgumentParser) -> None:
    _root(verb)
    verb.add_argument("--port", type=int, default=9090)


def _serve(given: argparse.Namespace) -> None:
    from silpose.recording import serve

    serve(given.folder, given.port)


def _catalog_options(verb: argparse.ArgumentParser) -> None:
    _root(verb)
    verb.add_argument("--port", type=int, default=0, help="any free one by default")


def _catalog(given: argparse.Namespace) -> None:
    from silpose.app.paths import rerun_command
    from silpose.recording import catalog
    from silpose.recording.viewer.process import until_interrupted

    with catalog(given.folder, given.port) as address:
        print(f"Open it:  {rerun_command()} {address}   (until Ctrl-C)", flush=True)
        until_interrupted()


def _repair(given: argparse.Namespace) -> None:
    from silpose.recording import repair

    _say_how_to_open(repair(given.run))


def _list(given: argparse.Namespace) -> None:
    from silpose.app.run_list import print_runs

    print_runs(given.folder)


def _open(given: argparse.Namespace) -> None:
    from silpose.recording import open_recording

    recording = _recording(given.run)
    if not open_recording(recording):
        print("there is no screen here; on a machine with one:")
        _say_how_to_open(recording)


def _settings_options(verb: argparse.ArgumentParser) -> None:
    verb.add_argument(
        "arguments",
        nargs="*",
        metavar="GROUP | key=value",
        help="groups or parts of them, such as regression or silhouette.camera, or experiment for "
        "the experiment's own; and overrides to compose with",
    )


def _settings(given: argparse.Namespace) -> None:
    from silpose.app.settings_table import print_settings

    wanted = [argument for argument in given.arguments if "=" not in argument]
    print_settings(wanted, [argument for argument in given.arguments if "=" in argument])


TOOLS = {
    "list": Tool("[FOLDER]", "the runs below a folder, as a table", _root, _list),
    "open": Tool("RUN", "a run's recording in the viewer", _one_run, _open),
    "compare": Tool("RUN…", "runs on one timeline, in one recording", _compare_options, _compare),
    "picture": Tool("RUN", "a frame of a recording, without a screen", _picture_options, _picture),
    "film": Tool("RUN", "a stretch of a recording as GIF or MP4", _film_options, _film),
    "catalog": Tool("[FOLDER]", "recordings as a table in Rerun", _catalog_options, _catalog),
    "serve": Tool("[FOLDER]", "runs in the browser, on this machine only", _serve_options, _serve),
    "repair": Tool("RUN", "salvage a recording that was cut off", _one_run, _repair),
    "settings": Tool("[GROUP]", "what can be set, and what it means", _settings_options, _settings),
}
"""All tools, in the order of the help text."""
