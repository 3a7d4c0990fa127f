"""The one way in for masks of any origin."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from PIL import Image

from silpose.core.errors import InputError
from silpose.silhouette.masks.arrays import WANTED, picture_of_item, pictures_of_array
from silpose.silhouette.masks.coco import pictures_of_records
from silpose.silhouette.masks.decision import decide
from silpose.silhouette.masks.image_files import Animation
from silpose.silhouette.masks.json_forms import is_record
from silpose.silhouette.masks.mask_source import MaskSource
from silpose.silhouette.masks.path_sources import Found, find_pictures
from silpose.silhouette.masks.sequence import MaskSequence


def read_masks(source: Any, options: MaskSource | None = None) -> MaskSequence:
    """Read all masks of a source, blank ones included.

    Parameters
    ----------
    source : path, array, list or iterable
        Path of a mask image, of a folder of them, of a video, of an array (``.npy``, ``.npz``) or
        of run-length encoded masks (``.json``), or a pattern such as ``'FOLDER/*_mask.png'``; an
        array (F, H, W) or (F, H, W, C), or (H, W) for one mask; a list or an iterable of arrays
        (H, W) or (H, W, C), of images of Pillow, of paths, or of run lengths.
    options : MaskSource, optional
        What pixels do not tell; its own source is not used.

    Returns
    -------
    sequence : MaskSequence

    Raises
    ------
    InputError
        If the source cannot be read, or holds no masks; it says what to do.

    Warns
    -----
    UserWarning
        If there is a doubt about the source.

    Notes
    -----
    How values become masks is decided for the source, not for each picture: a blank picture stays
    blank, and an array gives the same masks as the files that hold it.
    """
    if isinstance(source, MaskSequence):
        return source
    options = options or MaskSource()
    found = _find(source, options)
    pictures = found.animation.pictures
    encoding = decide(pictures, options, found.source)
    doubts = (*found.doubts, *found.animation.doubts, *encoding.doubts)
    for doubt in doubts:
        warnings.warn(doubt, UserWarning, stacklevel=2)
    names = [picture.name for picture in pictures]
    return MaskSequence(
        [encoding.apply(pictures.pop()) for _ in names][::-1],  # a long video fits into memory once
        names,
        found.source,
        encoding.words,
        found.animation.frames_per_second,
        found.notes,
        doubts,
        found.ignored,
    )


def _find(source: Any, options: MaskSource) -> Found:
    if source is None:
        raise InputError(f"there are no masks, but None: {WANTED}")
    if isinstance(source, str | os.PathLike):
        return find_pictures(source, options)
    if isinstance(source, Image.Image):
        return Found(Animation(picture_of_item(source, 0, "the image")), "the image")
    if isinstance(source, Mapping):
        pictures, doubts = pictures_of_records(source, "the mapping")
        return Found(Animation(pictures), "the mapping", doubts=doubts)
    if hasattr(source, "__array__"):
        name = "the array"
        return Found(Animation(pictures_of_array(np.asarray(source), name)), name)
    if not isinstance(source, Iterable):
        raise InputError(f"{type(source).__name__} {source!r} holds no masks: {WANTED}")
    return _find_items(list(source), options)


def _find_items(items: list[Any], options: MaskSource) -> Found:
    name = "the list"
    if not items:
        raise InputError(f"the list holds no masks: {WANTED}")
    if any(is_record(item) for item in items):
        pictures, doubts = pictures_of_records(items, name)
        return Found(Animation(pictures), name, doubts=doubts)
    pictures = []
    for position, item in enumerate(items):
        if isinstance(item, str | os.PathLike):
            pictures += find_pictures(item, options).animation.pictures
        else:
            pictures += picture_of_item(item, position, name)
    return Found(Animation(pictures), name)
