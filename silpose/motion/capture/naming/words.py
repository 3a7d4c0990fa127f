"""Names of joints, taken apart: side, word, number."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import yaml

_SIDES = {
    **dict.fromkeys(
        ("left", "Left", "LEFT", "l", "L", "lft", "Lft", "lf", "Lf", "Lt", "左"), "left"
    ),
    **dict.fromkeys(("right", "Right", "RIGHT", "r", "R", "rgt", "Rgt", "rt", "Rt", "右"), "right"),
}
_GLUED = {"left": "left", "l": "left", "right": "right", "r": "right"}  # lhumerus, upperarmr
_EMPTY = {"jnt", "joint", "jt", "bone", "bn", "def", "org", "bend", "stretch", "c", "x", "m", "sk"}
_HELPERS = {
    *("twist", "roll", "ik", "fk", "pole", "target", "goal", "ctrl", "control", "end", "nub"),
    *("dummy", "tip", "site", "helper", "leaf", "effector", "socket", "tweak", "mch"),
}
_TOKENS = re.compile(r"左|右|[A-Z]+(?![a-z])|[A-Z]?[a-z]+|[^\W\d_a-zA-Z左右]+|\d+")


@dataclass(frozen=True)
class Word:
    """What a joint's name says.

    Attributes
    ----------
    side : str
        ``left``, ``right``, or empty.
    word : str
        One of the words of the table, empty if the name has none.
    number : int or None
        That follows the word.
    helper : bool
        Whether the name says that this is no joint of a person itself: a twist bone, a target, an
        end.
    partly : bool
        Whether the name goes on after the word, which makes it a doubtful one.
    """

    side: str
    word: str
    number: int | None = None
    helper: bool = False
    partly: bool = False


@cache
def joint_words() -> Mapping[str, Sequence[str]]:
    """Read the table ``joint_words.yaml`` beside this file: words by what they stand for."""
    table = Path(__file__).with_name("joint_words.yaml")
    words: dict[str, list[str]] = yaml.safe_load(table.read_text(encoding="utf-8"))
    return words


@cache
def _known() -> frozenset[str]:
    return frozenset(word for words in joint_words().values() for word in words)


@cache
def read_name(name: str) -> Word:
    """Take a joint's name apart.

    Parameters
    ----------
    name : str
        Such as ``mixamorig:LeftUpLeg``, ``Bip01 L Thigh``, ``DEF-upper_arm.L`` or ``lhumerus``.
    """
    tokens = _TOKENS.findall(re.split(r"[:|]", name)[-1])
    sides = [_SIDES[token] for token in tokens if token in _SIDES]
    tokens = [token.lower() for token in tokens if token not in _SIDES]
    helper = any(token in _HELPERS for token in tokens) or bool(re.search(r"/end\d*$", name))
    kept = [token for token in tokens if token not in _HELPERS and token not in _EMPTY]
    number = None
    while kept and kept[-1].isdigit():
        number = int(kept.pop())
    side = sides[-1] if sides else ""
    for found, partly in _readings(kept, bool(side)):
        return Word(found.side or side, found.word, number, helper, partly)
    return Word(side, "", number, helper)


def _readings(tokens: Sequence[str], has_side: bool) -> Iterator[tuple[Word, bool]]:
    """Known words at the end of the tokens, the longest first; then such within them.

    The second item is True where the word is not at the end.
    """
    for end in range(len(tokens), 0, -1):
        for start in range(end):
            joined = "".join(t for t in tokens[start:end] if not t.isdigit())
            if (word := _known_word(joined, has_side)) is not None:
                yield word, end < len(tokens)


def _known_word(text: str, has_side: bool) -> Word | None:
    """Read text that is a known word, or one with a side before or behind it if it has none yet."""
    for short, side in _GLUED.items() if not has_side else ():
        if text.startswith(short) and text[len(short) :] in _known():
            return Word(side, text[len(short) :])
        if text.endswith(short) and text[: -len(short)] in _known():
            return Word(side, text[: -len(short)])
    return Word("", text) if text in _known() else None
