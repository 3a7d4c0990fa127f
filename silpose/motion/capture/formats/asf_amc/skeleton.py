"""Skeletons in ASF files: bones with directions, lengths and axes of their own."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.motion.capture.formats.text_file import DAMAGED, number, read_lines, shown

ROOT = "root"
LARGEST = 1e6
"""Larger numbers, in degrees or units of length, are damage."""

_DEGREES_OF_FREEDOM = ("rx", "ry", "rz", "tx", "ty", "tz", "l")


@dataclass
class Bone:
    """A bone, or the root, whose length is 0.

    Attributes
    ----------
    name : str
    line : int
        Where the file begins it, from 1.
    vector : ndarray, shape (3,)
        From its start to its end in the rest pose.
    axes : ndarray, shape (3, 3)
        Rotation of the axes about which it is turned.
    moves : tuple of str
        Degrees of freedom in the order of an AMC's values, such as ``rx``.
    parent : str or None
    """

    name: str
    line: int
    vector: Array = field(default_factory=lambda: np.zeros(3))
    axes: Array = field(default_factory=lambda: np.eye(3))
    moves: tuple[str, ...] = ()
    parent: str | None = None


@dataclass(frozen=True)
class Skeleton:
    """An ASF file's skeleton.

    Attributes
    ----------
    bones : dict of str to Bone
        A parent before its children; the root comes first.
    length : float
        The unit of length as the file states it; 0.45 at CMU.
    degrees : bool
        Whether angles are in degrees.
    """

    bones: dict[str, Bone]
    length: float
    degrees: bool


class _Section:
    """Lines of a section, as words."""

    def __init__(self, file: Path) -> None:
        self.file = file
        self.lines: list[tuple[int, list[str]]] = []

    def blocks(self) -> list[list[tuple[int, list[str]]]]:
        """Lines between begin and end; without these, all lines."""
        found: list[list[tuple[int, list[str]]]] = []
        current: list[tuple[int, list[str]]] | None = None
        for n, words in self.lines:
            if words[0].lower() == "begin":
                current = []
            elif words[0].lower() == "end":
                if current is not None:
                    found.append(current)
                current = None
            elif current is not None:
                current.append((n, words))
        if current is not None:
            raise InputError(f"{self.file}: line {self.lines[-1][0]}: 'end' is missing; {DAMAGED}")
        marks = ("begin", "end")
        return found or [[line for line in self.lines if line[1][0].lower() not in marks]]


def read_skeleton(file: Path) -> Skeleton:
    """Read an ASF file.

    Raises
    ------
    InputError
        If it is no ASF file or damaged; the message names the line.
    """
    lines, _ = read_lines(file, "ASF file")
    sections: dict[str, _Section] = {}
    name = ""
    for n, line in enumerate(lines, start=1):
        words = line.partition("#")[0].split()
        if not words:
            continue
        if words[0].startswith(":"):
            name, words = words[0][1:].lower(), words[1:]
            sections.setdefault(name, _Section(file))
        if words and name:
            sections[name].lines.append((n, words))
    missing = [name for name in ("root", "bonedata", "hierarchy") if name not in sections]
    if missing:
        raise InputError(f"{file}: is no ASF file or not whole: it has no ':{missing[0]}'")
    length, degrees = _units(sections.get("units"))
    bones = {ROOT: _root(sections["root"], degrees)}
    for block in sections["bonedata"].blocks():
        bone = _bone(block, file, degrees)
        if bone.name in bones:
            raise InputError(f"{file}: line {bone.line}: has two bones '{bone.name}'; {DAMAGED}")
        bones[bone.name] = bone
    return Skeleton(_ordered(sections["hierarchy"], bones, file), length, degrees)


def _units(section: _Section | None) -> tuple[float, bool]:
    stated = {} if section is None else {w[0].lower(): w[-1] for _, w in section.lines}
    return number(stated.get("length", "1")), not stated.get("angle", "deg").lower().startswith("r")


def _root(section: _Section, degrees: bool) -> Bone:
    root = Bone(
        ROOT,
        section.lines[0][0] if section.lines else 1,
        moves=("tx", "ty", "tz", "rx", "ry", "rz"),
    )
    order, turn = "XYZ", np.zeros(3)
    for n, words in section.lines:
        keyword = words[0].lower()
        if keyword == "order":
            root.moves = _moves(words[1:], n, section.file)
        elif keyword == "axis":
            order = words[-1]
        elif keyword == "orientation":
            turn = _numbers(words[1:4], n, section.file)
    root.axes = _axes(order, turn, degrees, root.line, section.file)
    return root


def _bone(block: list[tuple[int, list[str]]], file: Path, degrees: bool) -> Bone:
    bone = Bone("", block[0][0] if block else 1)
    direction, length = np.zeros(3), 0.0
    for n, words in block:
        keyword, rest = words[0].lower(), words[1:]
        if keyword == "name":
            bone.name = " ".join(rest)
        elif keyword == "direction":
            direction = _numbers(rest, n, file)
        elif keyword == "length":
            (length,) = _numbers(rest, n, file, count=1)
        elif keyword == "axis":
            bone.axes = _axes(
                rest[-1] if len(rest) > 3 else "XYZ", _numbers(rest[:3], n, file), degrees, n, file
            )
        elif keyword == "dof":
            bone.moves = _moves(rest, n, file)
    if not bone.name:
        raise InputError(f"{file}: line {bone.line}: a bone has no name; {DAMAGED}")
    size = np.linalg.norm(direction)
    if length and size < 1e-9:
        raise InputError(f"{file}: line {bone.line}: '{bone.name}' has no direction; {DAMAGED}")
    bone.vector = direction * (length / size if length else 0.0)
    return bone


def _axes(order: str, turn: Array, degrees: bool, line: int, file: Path) -> Array:
    if sorted(order.lower()) != ["x", "y", "z"]:
        raise InputError(f"{file}: line {line}: {shown(order)} is no order of axes such as XYZ")
    turned = [turn["xyz".index(axis)] for axis in order.lower()]
    return Rotation.from_euler(order.lower(), turned, degrees=degrees).as_matrix()


def _moves(words: list[str], line: int, file: Path) -> tuple[str, ...]:
    moves = tuple(word.lower() for word in words)
    for move in moves:
        if move not in _DEGREES_OF_FREEDOM or moves.count(move) > 1:
            raise InputError(
                f"{file}: line {line}: {shown(move)} is no degree of freedom; {DAMAGED}"
            )
    return moves


def _numbers(words: list[str], line: int, file: Path, count: int = 3) -> Array:
    values = np.array([number(word) for word in words[:count]])
    if len(values) < count or not (np.abs(values) < LARGEST).all():
        raise InputError(
            f"{file}: line {line}: {count} numbers should be here, not {shown(' '.join(words))}; "
            f"{DAMAGED}"
        )
    return values


def _ordered(section: _Section, bones: dict[str, Bone], file: Path) -> dict[str, Bone]:
    """Give each bone its parent, and sort them so that parents come first."""
    children: dict[str, list[str]] = {}
    for block in section.blocks():
        for n, (parent, *below) in block:
            for name in (parent, *below):
                if name not in bones:
                    raise InputError(f"{file}: line {n}: there is no bone {shown(name)}; {DAMAGED}")
            for name in below:
                if bones[name].parent is not None or name == ROOT:
                    raise InputError(f"{file}: line {n}: '{name}' has two parents; {DAMAGED}")
                bones[name].parent = parent
            children.setdefault(parent, []).extend(below)
    found, waiting = {}, [ROOT]
    while waiting:
        name = waiting.pop(0)
        found[name] = bones[name]
        waiting = children.get(name, []) + waiting
    if lost := [name for name in bones if name not in found]:
        raise InputError(
            f"{file}: line {bones[lost[0]].line}: '{lost[0]}' has no parent; {DAMAGED}"
        )
    return found
