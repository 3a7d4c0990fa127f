"""Masks as text in the form of YOLO: a file for each picture, a polygon on each line."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from PIL import Image

from silpose.core.errors import InputError
from silpose.silhouette.masks.coco import pictures_of_records
from silpose.silhouette.masks.image_files import IMAGES
from silpose.silhouette.masks.natural_order import in_natural_order
from silpose.silhouette.masks.picture import Picture

LABELS, _PICTURES = "labels", "images"
"""Folders beside each other, of texts and of the images that belong to them."""

_PERSON = 0  # of the classes, as in YOLO's own models
_BOX = (4, 5)  # numbers on the line of a box, without and with its score


def is_yolo(file: Path) -> bool:
    """Whether the first line of a text file is one of YOLO: a class, and shares of a picture."""
    with file.open("rb") as stream:
        first = stream.readline(65536).decode("latin-1").split()
    if not first or not first[0].isdecimal():
        return False
    values = _numbers(first[1:])
    if values is None or not all(0 <= value <= 1 for value in values):
        return False
    return len(values) in _BOX or len(values) >= 6


def yolo_files(folder: Path) -> list[Path]:
    """List a folder's texts, if they are of YOLO: an empty one, a picture of nobody, is one, too.

    Returns
    -------
    files : list of Path
        In natural order; none if a text with something in it is of another form.
    """
    files = [
        file
        for file in sorted(folder.glob("*.txt"))
        if file.is_file() and file.name not in ("classes.txt", "notes.txt")
    ]
    filled = [file for file in files if file.stat().st_size]
    if not filled or not all(is_yolo(file) for file in filled):
        return []
    return [files[k] for k in in_natural_order([file.stem for file in files])]


def read_yolo(files: Sequence[Path]) -> list[Picture]:
    """Read people, a picture for each file.

    A picture's size is that of the image with the same name, which is looked for beside the text,
    and in ``images`` where the text is in ``labels``.

    Raises
    ------
    InputError
        If a line is not of that form or a box, if a text has no image, or if there are no people.
    """
    images, annotations = [], []
    for number, file in enumerate(files):
        width, height = _size(file)
        images.append({"id": number, "file_name": file.stem, "height": height, "width": width})
        for polygon in _people(file):
            sides = [width, height] * (len(polygon) // 2)
            shape = [share * side for share, side in zip(polygon, sides, strict=True)]
            annotations.append({"image_id": number, "segmentation": [shape]})
    if not annotations:
        raise InputError(
            f"'{files[0]}' and what is beside it hold no people: in YOLO their class is {_PERSON}"
        )
    content: dict[str, Any] = {"images": images, "annotations": annotations}
    return pictures_of_records(content, f"'{files[0].parent}'")[0]


def labels_of(folder: Path) -> Path | None:
    """Return the folder of the texts that belong to a folder of images, if its path names one."""
    return _beside(folder, _PICTURES, LABELS)


def _beside(folder: Path, own: str, other: str) -> Path | None:
    """Replace the last part of a path that has one name by another, as YOLO does."""
    parts = list(folder.absolute().parts)
    if own not in parts:
        return None
    parts[len(parts) - 1 - parts[::-1].index(own)] = other
    return Path(*parts)


def _people(file: Path) -> list[list[float]]:
    found = []
    for number, line in enumerate(file.read_text(encoding="latin-1").splitlines(), 1):
        words = line.split()
        if not words:
            continue
        values = _numbers(words[1:])
        if values is not None and len(values) in _BOX:
            raise InputError(
                f"line {number} of '{file}' is a box, and no mask: segment by a model of YOLO "
                "whose name ends in -seg"
            )
        if values is None or len(values) < 6 or not words[0].isdecimal():
            raise InputError(f"line {number} of '{file}' is incomplete or damaged: write it anew")
        if int(words[0]) == _PERSON:
            found.append(values[: len(values) // 2 * 2])  # a score may come last
    return found


def _size(file: Path) -> tuple[int, int]:
    """Width and height of the image that a text belongs to."""
    folders = [file.parent]
    if beside := _beside(file.parent, LABELS, _PICTURES):
        folders.append(beside)
    for folder in folders:
        for suffix in IMAGES:
            for name in (file.stem + suffix, file.stem + suffix.upper()):
                image = folder / name
                if image.is_file():
                    try:
                        with Image.open(image) as opened:
                            return opened.size
                    except OSError as error:
                        raise InputError(f"'{image}' cannot be read ({error})") from None
    raise InputError(
        f"'{file}' is of YOLO, whose polygons are shares of a picture, and there is no image "
        f"'{folders[-1] / file.stem}.jpg' that tells its size: put the images there"
    )


def _numbers(words: Sequence[str]) -> list[float] | None:
    try:
        return [float(word) for word in words]
    except ValueError:
        return None
