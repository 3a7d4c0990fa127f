"""Verbs that are tools: for what runs leave behind, and for settings."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from silpose.app.pictures import (
    film_options,
    paint_film,
    paint_picture,
    picture_options,
    recording_of,
)
from silpose.app.served import catalog, catalog_options, root_option, serve, serve_options
from silpose.core.stage_lines import stage_lines
from silpose.core.stages import stage

_NAMED = 4  # runs, at most, that are all in the name of their comparison


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
    example : str
        What may follow the verb.
    """

    argument: str
    help: str
    options: Callable[[argparse.ArgumentParser], None]
    run: Callable[[argparse.Namespace], None]
    example: str


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


def _say_how_to_open(recording: Path) -> None:
    from silpose.app.paths import pasted, rerun_command

    print(f"Open it:  {rerun_command()} {pasted(recording)}")


def _one_run(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("run", type=Path, metavar="RUN", help="a run's folder, or a recording")


def _compare_options(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("runs", nargs="+", type=Path, metavar="RUN", help="folders of runs")
    named = "recording; named after the runs if not set"
    verb.add_argument("-o", "--output", type=Path, help=named)
    verb.add_argument("--method", help="whose errors are drawn")


def _compare(given: argparse.Namespace) -> None:
    from silpose.recording import load_run

    runs = [load_run(folder) for folder in given.runs]
    names = [run.folder.name for run in runs]
    if len(names) > _NAMED:
        names = [names[0], "to", names[-1]]
    output = given.output or Path(f"{runs[0].experiment}_{'_'.join(names)}.rrd")
    with stage_lines(), stage("comparing"):
        from silpose.recording import compare  # loads Rerun, which takes a second or more

        compare(runs, output, given.method)
    _say_how_to_open(output)


def _repair(given: argparse.Namespace) -> None:
    from silpose.recording import repair

    _say_how_to_open(repair(given.run))


def _list(given: argparse.Namespace) -> None:
    from silpose.app.run_list import print_runs

    print_runs(given.folder)


def _open_options(verb: argparse.ArgumentParser) -> None:
    newest = "a run's folder, or a recording; the run that was finished last if not given"
    verb.add_argument("run", nargs="?", type=Path, metavar="RUN", help=newest)


def _open(given: argparse.Namespace) -> None:
    from silpose.app.paths import shorten_path
    from silpose.recording import newest_run, open_recording

    recording = recording_of(given.run or newest_run().folder)
    if open_recording(recording):
        print(f"Opening {shorten_path(recording)}")
    else:
        print("there is no screen here; on a machine with one:")
        _say_how_to_open(recording)


def _paper_options(verb: argparse.ArgumentParser) -> None:
    verb.add_argument(
        "arguments",
        nargs="*",
        metavar="key=value",
        help="paper.parts=[tracking,mixture], paper.fast=true, paper.seeds=3, paper.authors=FILE, "
        "paper.video=FILE, paper.root=FOLDER, paper.name=NAME; and settings of all experiments, "
        "such as motion=bvh motion.root=FOLDER",
    )


def _paper(given: argparse.Namespace) -> None:
    from silpose.app.paper import parse, run_paper
    from silpose.app.paths import pasted

    report = run_paper(parse(given.arguments))
    for part, reason in report.failed.items():
        print(f"{part} failed: {reason}")
    counts = ", ".join(f"{count} {word}" for word, count in report.counts().items())
    print(f"Claims: {counts}. Read it:  {pasted(report.folder / 'report.html')}")
    if report.failed:
        raise SystemExit(1)


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


def _completion_options(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("shell", choices=("bash", "zsh"))


def _completion(given: argparse.Namespace) -> None:
    from silpose.app.completion import completion_script
    from silpose.app.verbs import EXPERIMENT_VERBS

    print(completion_script(given.shell, tuple(EXPERIMENT_VERBS), tuple(TOOLS)))


_RUN = "recordings/tracking/001"

TOOLS = {
    "list": Tool("[FOLDER]", "experiments with their questions, and runs", root_option, _list, ""),
    "open": Tool(
        "[RUN]",
        "a run's recording in the viewer, the newest by default",
        _open_options,
        _open,
        _RUN,
    ),
    "compare": Tool(
        "RUN…",
        "runs on one timeline, in one recording",
        _compare_options,
        _compare,
        f"{_RUN} recordings/tracking/002",
    ),
    "picture": Tool(
        "RUN",
        "a frame of a recording, without a screen",
        picture_options,
        paint_picture,
        f"{_RUN} --frame 120",
    ),
    "film": Tool(
        "RUN",
        "a stretch of a recording as GIF or MP4",
        film_options,
        paint_film,
        f"{_RUN} --view true --last 90",
    ),
    "catalog": Tool(
        "[FOLDER]",
        "recordings as a table in the viewer",
        catalog_options,
        catalog,
        "recordings/tracking",
    ),
    "serve": Tool(
        "[FOLDER]", "runs in the browser, on this machine only", serve_options, serve, ""
    ),
    "repair": Tool("RUN", "salvage a recording that was cut off", _one_run, _repair, _RUN),
    "paper": Tool(
        "[key=value …]",
        "every experiment of the paper, and one report of them",
        _paper_options,
        _paper,
        "paper.fast=true",
    ),
    "settings": Tool(
        "[GROUP]",
        "what can be set, and what it means",
        _settings_options,
        _settings,
        "regression",
    ),
    "completion": Tool(
        "SHELL",
        "commands, runs and choices completed",
        _completion_options,
        _completion,
        "bash >> ~/.bashrc",
    ),
}
"""All tools, in the order of the help text."""
