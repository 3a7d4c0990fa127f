"""Pictures of masks in JSON: run-length encoded, polygons, or rows of pixels."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from silpose.core.array_files import first_line
from silpose.core.errors import InputError
from silpose.core.types import Mask
from silpose.silhouette.masks.json_forms import WANTED, Record, records_of
from silpose.silhouette.masks.labelme import dataset_of_labelme, is_labelme
from silpose.silhouette.masks.natural_order import in_natural_order
from silpose.silhouette.masks.picture import Picture
from silpose.silhouette.masks.run_lengths import check_size, is_run_lengths, mask_of_run_lengths

Pictures = tuple[list[Picture], tuple[str, ...]]
"""Pictures, and what is doubtful about them."""

_FARTHEST = 1e6  # pixels
_IDENTITIES = ("track_id", "instance_id", "object_id", "obj_id", "person_id")


def read_coco(file: Path) -> Pictures:
    """Read a JSON file of masks: a picture for each image, and what is doubtful.

    Raises
    ------
    InputError
        If it is no JSON, or holds no masks, or a mask that does not fit its size.
    """
    return pictures_of_records(_content(file), f"'{file}'")


def read_labelme(files: Sequence[Path], source: str) -> Pictures | None:
    """Read LabelMe's files of a folder, a picture for each; None if they are something else.

    Who is the person is decided for all: a file without one is a blank picture.
    """
    contents = {file.name: _content(file) for file in files}
    if not all(map(is_labelme, contents.values())):
        return None
    with _values_of_any_kind(source):
        return _pictures(dataset_of_labelme(contents, source), source)


def _content(file: Path) -> Any:
    try:
        return json.loads(file.read_text(encoding="utf-8-sig"))
    except (OSError, ValueError) as error:
        raise InputError(f"'{file}' is incomplete, or no JSON ({error}): write it anew") from None


def pictures_of_records(content: Any, source: str) -> Pictures:
    """Make a picture of each image that JSON tells of; images without any mask are blank.

    Parameters
    ----------
    content : mapping or sequence
        As of `records_of`.
    source : str
        What it is called in messages.
    """
    with _values_of_any_kind(source):
        return _pictures(content, source)


@contextmanager
def _values_of_any_kind(source: str) -> Iterator[None]:
    """Refuse what JSON holds where it should be a number, text or a list."""
    try:
        yield
    except InputError:
        raise
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        raise InputError(
            f"{source} holds a value of another kind than it should ({first_line(error)}): {WANTED}"
        ) from None


def _pictures(content: Any, source: str) -> Pictures:
    held = records_of(content, source)
    sizes = {i.get("id"): _size(i, source) for i in held.images}
    names = {i.get("id"): str(i.get("file_name") or f"image {i.get('id')}") for i in held.images}
    found: dict[Any, list[Record]] = {key: [] for key in names}
    for record in held.records:
        found.setdefault(record.get("image_id"), []).append(record)
    keys = list(found)
    called = [names.get(key, f"image {key}") for key in keys]
    order = in_natural_order(called)
    drawn = [_draw(found[keys[k]], sizes.get(keys[k]), f"{called[k]} of {source}") for k in order]
    shape = next((plane.shape for plane in drawn if plane is not None), None)
    if shape is None:
        raise InputError(f"{source} holds no masks, and no image has a height and width")
    kind = max((p.dtype for p in drawn if p is not None), key=lambda dtype: dtype.itemsize)
    planes = [np.zeros(shape, kind) if p is None else p.astype(kind) for p in drawn]
    pictures = [Picture(p, called[k]) for p, k in zip(planes, order, strict=True)]
    return pictures, held.doubts


def _size(image: Record, source: str) -> tuple[int, int] | None:
    """Height and width of an image; None if it does not tell them."""
    height, width = image.get("height"), image.get("width")
    if not height or not width:
        return None
    check_size(int(height), int(width), source)
    return int(height), int(width)


def _draw(records: list[Record], size: tuple[int, int] | None, source: str) -> np.ndarray | None:
    """Draw the masks of one image: with the identities that they have, else all as one."""
    records = [record for record in records if record.get("segmentation") is not None]
    if not records:
        return np.zeros(size, np.uint8) if size else None
    plane: np.ndarray | None = None
    for record in records:
        mask = _mask(record, size, source)
        identity = next((record[key] for key in _IDENTITIES if key in record), 1)
        if plane is None:
            plane = np.zeros(mask.shape, np.int32)
        if plane.shape != mask.shape:
            raise InputError(f"{source} has masks of several sizes: write them anew")
        try:
            plane[mask > 0] = int(identity)
        except (TypeError, ValueError):
            raise InputError(
                f"{source} has the identity '{identity}': give each person a number from 1"
            ) from None
    assert plane is not None
    return plane.astype(np.uint8) if plane.max() <= 1 else plane


def _mask(record: Record, size: tuple[int, int] | None, source: str) -> Mask:
    shape = record["segmentation"]
    if is_run_lengths(shape):
        return mask_of_run_lengths(shape, source)
    if hasattr(shape, "__array__") and np.ndim(shape) == 3 and len(shape) == 1:
        shape = np.asarray(shape)[0]  # SAM 2 keeps an axis of one for the object
    if _is_plane(shape):
        return (np.asarray(shape) > 0).astype(np.uint8)
    if not size:
        raise InputError(
            f"{source} is a polygon, and its image has no height and width: add them to 'images'"
        )
    return _polygons(shape, size, source)


def _is_plane(shape: Any) -> bool:
    """Whether rows of one length are a mask itself, of numbers that are 0 and 1 or booleans."""
    try:
        plane = np.asarray(shape)
    except ValueError:
        return False
    return plane.ndim == 2 and plane.size > 0 and plane.dtype.kind in "bui" and plane.max() <= 1


def _polygons(polygons: Any, size: Any, source: str) -> Mask:
    mask = np.zeros(size, np.uint8)
    try:
        points = [np.asarray(polygon, float).reshape(-1, 2) for polygon in polygons]
        if any(not (np.abs(polygon) < _FARTHEST).all() for polygon in points):
            raise ValueError("a corner is far outside the image, or no number")
    except (TypeError, ValueError) as error:
        raise InputError(
            f"{source} has a polygon that cannot be read ({error}): write it anew"
        ) from None
    # Corners are at whole numbers, and pixels' centres between them.
    for polygon in filter(len, points):
        cv2.fillPoly(mask, [np.rint((polygon - 0.5) * 16).astype(np.int32)], 1, shift=4)
    return mask
