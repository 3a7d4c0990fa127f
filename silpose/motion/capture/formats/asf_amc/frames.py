"""Frames in AMC files: values of an ASF's bones."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.motion.capture.formats.asf_amc.skeleton import LARGEST, Skeleton
from silpose.motion.capture.formats.text_file import DAMAGED, number, read_lines, shown


@dataclass(frozen=True)
class Frames:
    """An AMC file's frames.

    Attributes
    ----------
    values : dict of str to ndarray, shape (F, moves of the bone)
    degrees : bool or None
        Whether angles are in degrees, if the file says it.
    frames_per_second : float or None
        If the file says it.
    notes : tuple of str
    """

    values: dict[str, Array]
    degrees: bool | None
    frames_per_second: float | None
    notes: tuple[str, ...]


def read_frames(file: Path, skeleton: Skeleton, asf: Path) -> Frames:
    """Read an AMC file.

    Raises
    ------
    InputError
        If it is no AMC file, damaged, or does not belong to the skeleton; the message names the
        line.
    """
    lines, _ = read_lines(file, "AMC file")
    degrees, rate, notes = None, None, []
    rows: dict[str, list[list[float]]] = {}
    wanted = {name for name, bone in skeleton.bones.items() if bone.moves}
    numbers: list[int] = []
    seen: set[str] = set()
    last = 0
    for n, line in enumerate(lines, start=1):
        words = line.partition("#")[0].split()
        if not words:
            continue
        last = n
        if words[0].startswith(":"):
            header = " ".join(words).lower()
            if header.startswith((":degrees", ":radians")):
                degrees = header.startswith(":degrees")
            elif found := re.match(r":samples-per-second\s+(\S+)", header):
                rate = number(found[1])
        elif len(words) == 1 and words[0].isdecimal() and words[0].isascii():
            _check_whole(seen, wanted, numbers, n, file)
            numbers.append(int(words[0][:12]))
            seen = set()
        elif numbers:
            _add(words, n, skeleton, seen, rows, file, asf)
        else:
            raise InputError(
                f"{file}: line {n}: {shown(words[0])} stands before the first frame's "
                f"number; {DAMAGED}"
            )
    if not numbers:
        raise InputError(f"{file}: is no AMC file, it has no frames; remove or replace it")
    _check_whole(seen, wanted, numbers, last, file)
    jumps = np.flatnonzero(np.diff(numbers) != 1)
    if jumps.size:
        before = numbers[int(jumps[0])]
        notes.append(
            f"its frame {before} is followed by {numbers[int(jumps[0]) + 1]}; frames are "
            "read as if none were missing"
        )
    return Frames({name: np.array(row) for name, row in rows.items()}, degrees, rate, tuple(notes))


def _add(
    words: list[str],
    line: int,
    skeleton: Skeleton,
    seen: set[str],
    rows: dict[str, list[list[float]]],
    file: Path,
    asf: Path,
) -> None:
    name, texts = words[0], words[1:]
    bone = skeleton.bones.get(name)
    if bone is None:
        raise InputError(
            f"{file}: line {line}: the skeleton {asf.name} has no bone {shown(name)}; put the ASF "
            "that belongs to this AMC beside it"
        )
    if name in seen:
        raise InputError(f"{file}: line {line}: '{name}' stands twice in a frame; {DAMAGED}")
    if len(texts) != len(bone.moves):
        raise InputError(
            f"{file}: line {line}: '{name}' has {len(texts)} values, but {len(bone.moves)} degrees "
            f"of freedom in {asf.name}; the ASF may be another one's, or the AMC truncated"
        )
    values = [number(text) for text in texts]
    for text, value in zip(texts, values, strict=True):
        if not abs(value) < LARGEST:
            raise InputError(
                f"{file}: line {line}: '{name}' has {shown(text)}, which is no number, not finite "
                f"or huge; {DAMAGED}"
            )
    seen.add(name)
    rows.setdefault(name, []).append(values)


def _check_whole(
    seen: set[str], wanted: set[str], numbers: list[int], line: int, file: Path
) -> None:
    """Refuse a frame without all bones, except that none may have been begun."""
    if numbers and (missing := sorted(wanted - seen)):
        raise InputError(
            f"{file}: line {line}: frame {numbers[-1]} ends without '{missing[0]}'; {DAMAGED}"
        )
