"""Verbs that run an experiment on a path, and the text of ``silpose --help``."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from silpose.app.commands import TOOLS
from silpose.app.conf_folder import groups
from silpose.app.typed_paths import quoted
from silpose.core.errors import InputError


@dataclass(frozen=True)
class Verb:
    """Short for an experiment with the path of its source.

    Attributes
    ----------
    help : str
    overrides : tuple of str
        What the verb stands for.
    source : str
        The setting that the path is for.
    example : str
        What may follow the verb.
    """

    help: str
    overrides: tuple[str, ...]
    source: str
    example: str = "PATH"


EXPERIMENT_VERBS = {
    "motion": Verb(
        "what is understood of motion capture, a file or a folder, with a picture",
        ("experiment=motion_report", "motion=bvh", "motion.formats=[bvh,amc,npz]"),
        "motion.root",
        "walks/",
    ),
    "predict": Verb(
        "poses for a folder or video of masks",
        ("experiment=predict", "silhouette=masks"),
        "silhouette.source",
        "my_masks/ lag=0.5",
    ),
    "video": Verb(
        "poses and gait of a person in a film, a folder of pictures, from a camera or a stream",
        ("experiment=video",),
        "silhouette.source",
        "walk.mp4 silhouette.body_height=1.75",
    ),
    "masks": Verb(
        "how masks are read, and what is in them",
        ("experiment=masks", "silhouette=masks", "recording=none"),
        "silhouette.source",
        "my_masks/",
    ),
}
"""A new verb takes one entry here."""

_EXPERIMENT = "experiment=tracking motion.seconds=20"
_SWEEP = "-m experiment=tracking seed=0,1,2"


def overrides_of(verb: str, arguments: Sequence[str]) -> list[str]:
    """Write a verb and its path as Hydra's overrides.

    Parameters
    ----------
    verb : str
        One of `EXPERIMENT_VERBS`.
    arguments : sequence of str
        The path, whatever characters it has, then overrides and Hydra's options.
    """
    if not arguments:
        raise InputError(f"'{verb}' needs a path: {usage(verb)}")
    path, *rest = arguments
    if "=" in path and "://" not in path and not Path(path).exists():
        raise InputError(f"there is no file '{path}'; the path comes first: {usage(verb)}")
    if rest and "=" not in rest[0] and Path(rest[0]).exists():
        raise InputError(
            f"'{verb}' takes one path, not '{path}' and '{rest[0]}': give the folder that holds "
            f"them, '{Path(path).parent}'"
        )
    short_for = EXPERIMENT_VERBS[verb]
    typed = {override.partition("=")[0] for override in rest}
    own = [override for override in short_for.overrides if override.partition("=")[0] not in typed]
    return [*own, f"{short_for.source}={quoted(path)}", *rest]


def usage(verb: str) -> str:
    """Show how a verb is typed."""
    return f"silpose {verb} PATH [key=value …]"


def verb_help(verb: str) -> str:
    """Describe a verb."""
    short_for = EXPERIMENT_VERBS[verb]
    stands_for = " ".join((*short_for.overrides, f"{short_for.source}=PATH"))
    return f"{usage(verb)}\n\n{short_for.help}; short for {stands_for}"


def help_text() -> str:
    """Describe the command: its verbs with examples, then the groups and their choices."""
    verbs = {
        "[key=value …]": ("an experiment, with its figure, numbers and recording", _EXPERIMENT),
        "-m [key=value,value …]": ("the same for each value", _SWEEP),
    }
    for name, verb in EXPERIMENT_VERBS.items():
        verbs[f"{name} PATH"] = verb.help, f"{name} {verb.example}"
    for name, tool in TOOLS.items():
        verbs[f"{name} {tool.argument}"] = tool.help, f"{name} {tool.example}"
    choices = {group: ", ".join(names) for group, names in groups().items()}
    first = max(map(len, (*verbs, *choices))) + 2
    return "\n".join(
        (
            "3D human pose from silhouettes by sparse regression, watched step by step in Rerun.",
            "",
            "Commands ('silpose COMMAND --help' has their options), each with an example:",
            *(line for name, words in verbs.items() for line in _with_example(name, *words, first)),
            "",
            "Groups and their choices (group=choice):",
            *_table(choices, first),
            "",
            "What each experiment asks: silpose list. Settings of a group: silpose settings GROUP",
        )
    )


def _with_example(name: str, words: str, example: str, first: int) -> list[str]:
    return [*_table({name: words}, first), f"  {'':<{first}}silpose {example.strip()}"]


def _table(rows: dict[str, str], first: int) -> list[str]:
    """Lay out two columns, the first of a given width."""
    lines = []
    for name, words in rows.items():
        begin = f"  {name:<{first}}"
        rest = " " * len(begin)
        lines.append(textwrap.fill(words, 96, initial_indent=begin, subsequent_indent=rest))
    return lines
