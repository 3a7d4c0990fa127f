"""The HIERARCHY of a BVH file: its joints, offsets and channels."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from silpose.core.errors import InputError
from silpose.motion.capture.formats.text_file import DAMAGED, number, shown

LARGEST = 1e6
"""Larger numbers, in degrees or units of length, are damage."""

LARGEST_TREE = 2000
"""Most joints and end sites: a person has at most some hundreds."""

_WHAT = {"pos": "p", "tra": "p", "rot": "r", "sca": "s"}
_CHANNEL = re.compile(
    r"([xyz])_?(pos|tra|rot|sca)\w*|(pos|tra|rot|sca)[a-z]*_?([xyz])", re.IGNORECASE
)


@dataclass
class Node:
    """A joint or an end site.

    Attributes
    ----------
    name : str
        An end site's is ``PARENT/end``.
    parent : int
        Index of the parent, -1 for a root.
    line : int
        Where the file names it, from 1.
    is_end : bool, default=False
        Whether it is an end site.
    channels : list of str
        Such as ``xp`` for a position along x, ``zr`` for a rotation about z, ``ys`` for a scale.
    offset : tuple of float or None
        From the parent; None as long as the file gives none.
    """

    name: str
    parent: int
    line: int
    is_end: bool = False
    channels: list[str] = field(default_factory=list)
    offset: tuple[float, float, float] | None = None


class _Words:
    """Words of some lines, one after the other, each with its line's number."""

    def __init__(self, lines: Sequence[str], file: Path) -> None:
        self.file = file
        self._last = len(lines)
        self._words = [
            (n, word)
            for n, line in enumerate(lines, start=1)
            if not line.lstrip().startswith(("#", "//"))
            for word in line.replace("{", " { ").replace("}", " } ").split()
        ]
        self._next = 0
        self.line = 0

    def take(self, what: str) -> str:
        """Take the next word."""
        if self._next >= len(self._words):
            raise InputError(
                f"{self.file}: line {self._last}: the HIERARCHY ends where {what} should follow; "
                f"{DAMAGED}"
            )
        self.line, word = self._words[self._next]
        self._next += 1
        return word

    def is_there(self) -> bool:
        return self._next < len(self._words)

    def rest_of_line(self) -> str:
        """Take what follows on the same line, up to a brace; names may hold spaces."""
        taken = []
        while self.is_there():
            line, word = self._words[self._next]
            if line != self.line or word in "{}":
                break
            taken.append(word)
            self._next += 1
        return " ".join(taken)

    def refuse(self, what: str) -> InputError:
        return InputError(f"{self.file}: line {self.line}: {what}; {DAMAGED}")


def parse_hierarchy(lines: Sequence[str], file: Path) -> list[Node]:
    """Read the joints of all roots, in the order of the file, which is that of the channels.

    Parameters
    ----------
    lines : sequence of str
        The file's lines up to MOTION; those before HIERARCHY are empty.
    file : Path
        Named in errors.

    Raises
    ------
    InputError
        If the hierarchy is damaged; the message names the line.
    """
    words = _Words(lines, file)
    nodes: list[Node] = []
    open_nodes: list[int] = []
    words.take("HIERARCHY")
    while words.is_there():
        keyword = words.take("a joint")
        kind = keyword.upper()
        parent = open_nodes[-1] if open_nodes else -1
        if kind in ("ROOT", "JOINT", "END", "ENDSITE"):
            if (kind == "ROOT") != (parent < 0):
                where = "inside another joint" if kind == "ROOT" else "outside of any ROOT"
                raise words.refuse(f"{shown(keyword)} stands {where}")
            if len(nodes) >= LARGEST_TREE:
                raise words.refuse(f"there are more than {LARGEST_TREE} joints")
            nodes.append(_named(words, kind, nodes, parent))
            open_nodes.append(len(nodes) - 1)
            if words.take("'{'") != "{":
                raise words.refuse(f"'{{' is missing after {shown(nodes[-1].name)}")
        elif keyword == "}":
            if parent < 0:
                raise words.refuse("there is a '}' too many")
            open_nodes.pop()
        elif parent < 0:
            raise words.refuse(f"{shown(keyword)} where ROOT should be")
        elif kind == "OFFSET":
            if nodes[parent].offset is not None:
                raise words.refuse(f"a second OFFSET of {shown(nodes[parent].name)}")
            nodes[parent].offset = _offset(words, nodes[parent])
        elif kind == "CHANNELS":
            if nodes[parent].channels:
                raise words.refuse(f"a second CHANNELS of {shown(nodes[parent].name)}")
            nodes[parent].channels = _channels(words)
        else:
            raise words.refuse(f"{shown(keyword)} where OFFSET, CHANNELS, JOINT or '}}' should be")
    if open_nodes:
        words.take("'}'")
    for node in nodes:
        if node.offset is None and not node.is_end and not {"xp", "yp", "zp"} <= set(node.channels):
            raise InputError(
                f"{file}: line {node.line}: {shown(node.name)} has no OFFSET; {DAMAGED}"
            )
    return nodes


def _named(words: _Words, kind: str, nodes: list[Node], parent: int) -> Node:
    line, name = words.line, words.rest_of_line()
    if kind.startswith("END"):
        return Node(f"{nodes[parent].name}/end", parent, line, is_end=True)
    if not name:
        raise words.refuse(f"{shown(kind)} has no name")
    return Node(name, parent, line)


def _offset(words: _Words, node: Node) -> tuple[float, float, float]:
    texts = [words.take("a number of OFFSET") for _ in range(3)]
    x, y, z = (number(text) for text in texts)
    if not all(abs(value) < LARGEST for value in (x, y, z)):
        wrong = next(t for t in texts if not abs(number(t)) < LARGEST)
        raise InputError(
            f"{words.file}: line {words.line}: the OFFSET of {shown(node.name)} holds "
            f"{shown(wrong)}, which is no number, not finite or huge; {DAMAGED}"
        )
    return x, y, z


def _channels(words: _Words) -> list[str]:
    text = words.take("the number of CHANNELS")
    count = number(text)
    if not (0 <= count <= 30 and count == int(count)):
        raise words.refuse(f"CHANNELS has {shown(text)} for their number")
    channels = []
    for _ in range(int(count)):
        word = words.take("a channel's name")
        fits = _CHANNEL.fullmatch(word)
        if fits is None:
            raise words.refuse(
                f"{shown(word)} where one of {int(count)} channels such as Xrotation should be"
            )
        axis, what = fits[1] or fits[4], fits[2] or fits[3]
        channel = axis.lower() + _WHAT[what.lower()]
        if channel in channels and channel[1] != "r":
            raise words.refuse(f"{shown(word)} stands twice")
        channels.append(channel)
    return channels
