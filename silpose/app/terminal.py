"""The standard output as tables and styled words are printed to it."""

from __future__ import annotations

import re
import textwrap

from rich.console import Console


class Terminal(Console):
    """The standard output; one that nobody reads any more ends the command without an error."""

    def on_broken_pipe(self) -> None:
        """Leave it to `silpose.app.main`, which ends quietly; by default the exit status is 1."""
        raise BrokenPipeError


def wrapped(words: str, width: int, indent: str = "") -> str:
    """Wrap text between words, and a name that is longer than a line after a dot or an underscore.

    Parameters
    ----------
    words : str
    width : int
        Characters of a line.
    indent : str, default=""
        What each line but the first begins with.
    """
    room = width - len(indent)
    whole = (
        word if len(word) <= room else " ".join(_pieces(word, room)) for word in words.split(" ")
    )
    return textwrap.fill(" ".join(whole), width, subsequent_indent=indent, break_on_hyphens=False)


def _pieces(name: str, room: int) -> list[str]:
    """Cut a name after dots and underscores into as few pieces as fit into a line."""
    pieces = [""]
    for part in re.split(r"(?<=[._/])", name):
        if pieces[-1] and len(pieces[-1]) + len(part) > room:
            pieces.append("")
        pieces[-1] += part
    return pieces
