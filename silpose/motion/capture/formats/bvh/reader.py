"""BVH files of any exporter, read rightly or refused with the line that is wrong."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import replace
from pathlib import Path

import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.motion.capture.formats.bvh.channels import local_motion
from silpose.motion.capture.formats.bvh.frames import Frames, parse_frames
from silpose.motion.capture.formats.bvh.hierarchy import LARGEST, Node, parse_hierarchy
from silpose.motion.capture.formats.text_file import DAMAGED, read_lines
from silpose.motion.capture.raw_motion import LARGEST_SIZE, RawMotion, world_from_local

FIGURE = 12
"""Number of joints from which a tree besides the person's is another figure and not a prop."""


def read_bvh(file: str | Path, frame_rate: float | None = None) -> RawMotion:
    """Read a BVH file.

    Parameters
    ----------
    file : str or Path
        Any channels in any order; keywords in any case; UTF-8, UTF-16 or Latin-1.
    frame_rate : float or None, default=None
        Frames per second in place of the file's frame time.

    Returns
    -------
    motion : RawMotion
        The largest tree if there are several roots. What was assumed is in its notes.

    Raises
    ------
    InputError
        If it is no BVH file, or its meaning is not sure; the message names the line.
    """
    file = Path(file)
    lines, complete = read_lines(file, "BVH file")
    lines, notes = _with_decimal_points(lines)
    begin = _first(lines, "HIERARCHY")
    motion = _first(lines, "MOTION")
    if motion is None:
        motion = len(lines)
    if begin is None or not any(re.search(r"(?i)\broot\b", line) for line in lines[begin:motion]):
        raise InputError(f"{file}: is no BVH file (no HIERARCHY with a ROOT); remove or replace it")
    nodes = parse_hierarchy(["" if n < begin else lines[n] for n in range(motion)], file)
    if motion == len(lines):
        raise InputError(f"{file}: line {motion}: it has no MOTION; {DAMAGED}")
    channels = sum(len(node.channels) for node in nodes)
    if not channels:
        raise InputError(f"{file}: none of its joints has CHANNELS; export it with its motion")
    rest = lines[motion].strip()[len("MOTION") :]
    lines[motion] = rest
    frames = parse_frames(lines, motion if rest else motion + 1, channels, complete, file)
    nodes, values, left_out = _person(nodes, frames.values, file)
    _check_values(nodes, values, frames, file)
    if len(values) * len(nodes) > LARGEST_SIZE:
        raise InputError(
            f"{file}: has {len(values)} frames of {len(nodes)} joints, more than fit into memory; "
            "split it into shorter takes"
        )
    rate, rounded = _rate(frames, frame_rate, file)
    rotations, positions, offsets, read_as = local_motion(nodes, values)
    parents = tuple(node.parent for node in nodes)
    rotations, positions = world_from_local(parents, rotations, positions)
    return RawMotion(
        file=str(file),
        names=_unique_names(nodes, file),
        parents=parents,
        offsets=offsets,
        rotations=rotations,
        positions=positions,
        frames_per_second=rate,
        format="BVH",
        notes=(*notes, *frames.notes, *left_out, *rounded, *read_as),
    )


def _first(lines: list[str], keyword: str) -> int | None:
    """Index of the first line that begins with a keyword."""
    begins = re.compile(rf"\s*{keyword}\b", re.IGNORECASE)
    return next((n for n, line in enumerate(lines) if begins.match(line)), None)


def _with_decimal_points(lines: list[str]) -> tuple[list[str], list[str]]:
    """Replace commas within numbers by points, and commas between numbers by spaces."""
    if not any("," in line for line in lines):
        return lines, []
    numbers = [re.match(r"\s*([-+.\d]|offset|frame)", line, re.IGNORECASE) for line in lines]
    text = "\n".join(line for line, is_number in zip(lines, numbers, strict=True) if is_number)
    decimal = re.search(r"\d,\d", text) and not re.search(r"\d\.\d|\d,\d+,", text)
    lines = [
        line.replace(",", "." if decimal else " ") if is_number else line
        for line, is_number in zip(lines, numbers, strict=True)
    ]
    return lines, ["its numbers have decimal commas"] if decimal else []


def _check_values(nodes: list[Node], values: Array, frames: Frames, file: Path) -> None:
    what = [channel[1] for node in nodes for channel in node.channels]
    bad = ~(np.abs(values) < LARGEST)
    if bad.any():
        frame = int(np.argmax(bad.any(axis=1)))
        kind = {"p": "position", "r": "rotation", "s": "scale"}[what[np.argmax(bad[frame])]]
        raise InputError(
            f"{file}: frame {frame}, line {frames.lines[frame]}, holds a {kind} that is not "
            "finite or huge; remove such frames or export the file again"
        )


def _rate(frames: Frames, frame_rate: float | None, file: Path) -> tuple[float, tuple[str, ...]]:
    if frame_rate is not None:
        return float(frame_rate), ()
    if frames.time is None:
        raise InputError(
            f"{file}: has no 'Frame Time:' line; add it, such as 'Frame Time: 0.033333', or give "
            "the rate by motion.frame_rate=30"
        )
    return frames.time.rate(file)


def _person(
    nodes: list[Node], values: Array, file: Path
) -> tuple[list[Node], Array, tuple[str, ...]]:
    """Choose the tree of the person among several roots."""
    tree: list[int] = []
    for j, node in enumerate(nodes):
        tree.append(j if node.parent < 0 else tree[node.parent])
    sizes = Counter(t for t, node in zip(tree, nodes, strict=True) if not node.is_end)
    if len(sizes) == 1:
        return nodes, values, ()
    (person, _), *others = sizes.most_common()
    if others[0][1] >= FIGURE:
        first, second = sorted((person, others[0][0]))
        raise InputError(
            f"{file}: holds two figures, ROOT '{nodes[first].name}' in line {nodes[first].line} "
            f"and ROOT '{nodes[second].name}' in line {nodes[second].line}; save each in a file of "
            "its own"
        )
    kept = [j for j in range(len(nodes)) if tree[j] == person]
    columns = [j for j, node in enumerate(nodes) for _ in node.channels]
    chosen = np.isin(columns, kept)
    place = {j: k for k, j in enumerate(kept)}
    mine = [replace(nodes[j], parent=place.get(nodes[j].parent, -1)) for j in kept]
    props = ", ".join(f"'{nodes[t].name}' in line {nodes[t].line}" for t, _ in others)
    note = f"the ROOT {props} is left out: the person is '{nodes[person].name}'"
    return mine, values[:, chosen], (note,)


def _unique_names(nodes: list[Node], file: Path) -> tuple[str, ...]:
    """Tell ends of one name apart by numbers; two joints of one name are refused."""
    inner = {node.parent for node in nodes}
    names: dict[str, bool] = {}
    for j, node in enumerate(nodes):
        name, number = node.name, 1
        if name in names and j in inner and names[name]:
            raise InputError(
                f"{file}: line {node.line}: has two joints '{name}'; give each a name of its own"
            )
        while name in names:
            number += 1
            name = f"{node.name}{number}"
        names[name] = j in inner
    return tuple(names)
