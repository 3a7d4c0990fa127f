"""Masks as text in the form of MOTS: a line for each object in each frame."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from silpose.core.errors import InputError
from silpose.silhouette.masks.coco import pictures_of_records
from silpose.silhouette.masks.picture import Picture

_LINE = re.compile(r"(\d+) (\d+) (\d+) (\d+) (\d+) (\S+)")  # frame, object, class, H, W, runs
_PERSON = 2  # of the classes: 1 is a car, 10 is to be ignored


def is_mots(file: Path) -> bool:
    """Whether the first line of a file is one of MOTS."""
    with file.open("rb") as stream:
        return _LINE.match(stream.readline(4096).decode("latin-1")) is not None


def read_mots(file: Path) -> list[Picture]:
    """Read people, a picture for each frame from the first to the last that is named.

    Raises
    ------
    InputError
        If a line is not of that form, or there are no people.
    """
    images: dict[int, dict[str, Any]] = {}
    annotations = []
    for number, line in enumerate(file.read_text(encoding="latin-1").splitlines(), 1):
        found = _LINE.fullmatch(line.strip())
        if found is None and line.strip():
            raise InputError(f"line {number} of '{file}' is incomplete or damaged: write it anew")
        if found is None:
            continue
        frame, identity, kind, height, width = (int(value) for value in found.groups()[:5])
        images[frame] = {"height": height, "width": width}
        if kind == _PERSON:
            runs = {"size": [height, width], "counts": found[6]}
            annotations.append({"image_id": frame, "track_id": identity, "segmentation": runs})
    if not annotations:
        raise InputError(f"'{file}' holds no people: in MOTS their class is {_PERSON}")
    size = next(iter(images.values()))
    every = [
        {"id": frame, "file_name": f"frame {frame}", **images.get(frame, size)}
        for frame in range(min(images), max(images) + 1)
    ]
    return pictures_of_records({"images": every, "annotations": annotations}, f"'{file}'")[0]
