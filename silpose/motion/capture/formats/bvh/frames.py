"""The MOTION of a BVH file: its number of frames, frame time and values."""

from __future__ import annotations

import re
from array import array
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.motion.capture.formats.bvh.frame_time import FrameTime
from silpose.motion.capture.formats.text_file import DAMAGED, number, shown

_FRAMES = re.compile(r"\bframe(?:s|\s*count)\b\s*[:=]?\s*(?!frame)(\S+)", re.IGNORECASE)
_TIME = re.compile(r"\bframe\s*time\b\s*[:=]?\s*(\S+)", re.IGNORECASE)
_HEADER = 12  # lines after MOTION in which both are looked for
_MAY_LACK = 0.01  # share of the frames, at least one frame


@dataclass(frozen=True)
class Frames:
    """Values of all channels.

    Attributes
    ----------
    values : ndarray, shape (F, C)
    lines : ndarray, shape (F,)
        Line of the file, from 1, at which each frame begins.
    time : FrameTime or None
        As the file has it; None if it has none.
    notes : tuple of str
    """

    values: Array
    lines: Array
    time: FrameTime | None
    notes: tuple[str, ...]


def parse_frames(lines: list[str], start: int, channels: int, complete: bool, file: Path) -> Frames:
    """Read all frames that are there, whatever number the file claims.

    Parameters
    ----------
    lines : list of str
        All lines of the file; values that follow the frame time get a line to themselves.
    start : int
        Index of the line after MOTION.
    channels : int
        Number of values in a frame.
    complete : bool
        Whether the last line has its end.
    file : Path
        Named in errors.

    Raises
    ------
    InputError
        If the frames are not whole, or many fewer than claimed; the message names the line.
    """
    claimed, time, first = _header(lines, start, file)
    values, counts, numbers = _numbers(lines, first, file)
    notes: list[str] = []
    if not values:
        if claimed:
            raise InputError(f"{file}: line {len(lines)}: its frames are missing; {DAMAGED}")
        raise InputError(f"{file}: line {first}: has no motion frames; export it with its motion")
    starts = _starts(counts, numbers, channels, claimed, file)
    frames = np.frombuffer(values).reshape(-1, channels)
    if claimed is not None and len(frames) < claimed:
        if claimed - len(frames) > _few(claimed):
            raise InputError(
                f"{file}: line {numbers[-1]}: it ends after {len(frames)} of {claimed} frames; it "
                f"may be truncated: download it again, or write 'Frames: {len(frames)}' into it"
            )
        if not complete and len(frames) > 1:  # its last number may have lost digits
            frames, starts = frames[:-1], starts[:-1]
    if claimed is None:
        notes.append(f"it has no 'Frames:' line; {len(frames)} frames were read")
    elif claimed != len(frames):
        notes.append(f"its 'Frames:' line says {claimed}; {len(frames)} frames were read")
    return Frames(frames, starts, time, tuple(notes))


def _header(lines: list[str], start: int, file: Path) -> tuple[int | None, FrameTime | None, int]:
    """Find the claimed number of frames, the frame time, and the index of the first values."""
    claimed, time, first = None, None, start
    head = "\n".join(lines[start : start + _HEADER])
    end = 0
    if found := _FRAMES.search(head):
        line = start + head.count("\n", 0, found.start(1)) + 1
        count, end = number(found[1]), found.end()
        if not (0 <= count < float("inf") and count == int(count)):
            raise InputError(
                f"{file}: line {line}: 'Frames:' is {shown(found[1])}; write the number of frames"
            )
        claimed = int(count)
    if found := _TIME.search(head):
        line = start + head.count("\n", 0, found.start(1)) + 1
        time, end = FrameTime(found[1], line), max(end, found.end())
    if end:
        first = start + head.count("\n", 0, end) + 1
        rest = head[end:].partition("\n")[0]
        if _is_number((rest.split() or [""])[0]):  # values that follow on the same line
            first -= 1
            lines[first] = rest
    return claimed, time, first


def _numbers(lines: Sequence[str], first: int, file: Path) -> tuple[array, list[int], list[int]]:
    """Read all numbers; for each line that has any, their count and its number."""
    values, counts, numbers = array("d"), [], []
    for n in range(first, len(lines)):
        words = lines[n].split()
        if not words or words[0].startswith(("#", "//")):
            continue
        try:
            values.extend(map(float, words))
        except ValueError:
            wrong = next((word for word in words if not _is_number(word)), words[0])
            if wrong.upper() in ("HIERARCHY", "ROOT", "MOTION"):
                raise InputError(
                    f"{file}: line {n + 1}: a second {wrong.upper()} begins; save each take in a "
                    "file of its own"
                ) from None
            raise InputError(
                f"{file}: line {n + 1}: {shown(wrong)} where a number should be; {DAMAGED}"
            ) from None
        counts.append(len(words))
        numbers.append(n + 1)
    return values, counts, numbers


def _few(claimed: int) -> float:
    return max(1, _MAY_LACK * claimed)


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def _starts(
    counts: list[int], numbers: list[int], channels: int, claimed: int | None, file: Path
) -> Array:
    """Find the line at which each frame begins, and check that all frames are whole.

    A frame is a line, or several lines, or lines hold several frames; or lines are broken
    anywhere, which is believed only if the number of values is exactly the claimed one.
    """
    count, number_of = np.array(counts), np.array(numbers)
    if (count == channels).all():
        return number_of
    total = int(count.sum())
    ends = np.cumsum(count)
    frames, rest = divmod(total, channels)
    most = (count == channels).mean() > 0.5
    expected = claimed is None or abs(frames - claimed) <= _few(claimed)
    if not most and not rest and expected:
        aligned = np.isin(channels * np.arange(1, frames + 1), ends).all()
        several = (count % channels == 0).all()
        if aligned or several or frames == claimed:
            where = np.searchsorted(ends, channels * np.arange(frames), side="right")
            return number_of[where]
    wrong = int(np.argmax(count != channels))
    if not most and (count == count[0]).all():
        raise InputError(
            f"{file}: line {numbers[0]}: its frames have {counts[0]} values, but its joints have "
            f"{channels} channels; {DAMAGED}"
        )
    raise InputError(
        f"{file}: line {numbers[wrong]}: has {counts[wrong]} values where its joints have "
        f"{channels} channels; {DAMAGED}"
    )
