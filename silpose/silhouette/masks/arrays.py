"""Pictures of arrays, lists of them, and images that Pillow has opened."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from PIL import Image

from silpose.core.errors import InputError
from silpose.silhouette.masks.image_files import pictures_of_image
from silpose.silhouette.masks.picture import Picture, Pixels, compact

_THINNEST = 8  # a picture whose sides differ more is an axis taken for another
_CHANNELS = (1, 2, 3, 4)

WANTED = "give an array (F, H, W), a list of arrays (H, W), or a path"


def pictures_of_array(array: Pixels, source: str) -> list[Picture]:
    """Split an array into pictures.

    Parameters
    ----------
    array : ndarray, shape (H, W), (F, H, W), (F, H, W, C) or (F, C, H, W)
        An array of objects is taken for the list of its items.
    source : str
        What it is called in messages.
    """
    if array.dtype == object:
        return pictures_of_items(list(array.ravel()) if array.ndim <= 1 else list(array), source)
    if array.ndim == 2:
        return [_picture(array, "frame 0", source)]
    if array.ndim == 4 and array.shape[1] in _CHANNELS and array.shape[3] not in _CHANNELS:
        array = np.moveaxis(array, 1, 3)
    if array.ndim == 3 and array.shape[2] in (3, 4) and min(array.shape[:2]) > _THINNEST:
        return [_picture(array, "frame 0", source)]  # one picture in colours
    if array.ndim not in (3, 4) or (array.ndim == 4 and array.shape[3] not in _CHANNELS):
        raise InputError(f"{source} has the shape {array.shape}: {WANTED}")
    if not len(array):
        raise InputError(f"{source} has the shape {array.shape} and no masks: {WANTED}")
    if array.ndim == 3:
        _check_order(array, source)
    return [_picture(frame, f"frame {k}", source) for k, frame in enumerate(array)]


def pictures_of_items(items: Sequence[Any] | Iterable[Any], source: str) -> list[Picture]:
    """Take each item of a list for a picture."""
    return [p for k, item in enumerate(items) for p in picture_of_item(item, k, source)]


def picture_of_item(item: Any, position: int, source: str) -> list[Picture]:
    """Take one item of a list for a picture, or for several if it is an image of many pages."""
    name = f"frame {position}"
    if isinstance(item, Image.Image):
        return pictures_of_image(item, name)
    if item is None:
        raise InputError(f"{name} of {source} is None: give an array of zeros for a blank mask")
    try:
        pixels = np.asarray(item)
    except (TypeError, ValueError, RuntimeError) as error:  # such as a tensor of a graphics card
        raise InputError(f"{name} of {source} is no array ({error}): {WANTED}") from None
    pixels = pixels[0] if pixels.ndim == 3 and pixels.shape[0] == 1 else pixels
    if pixels.ndim == 3 and pixels.shape[0] in (3, 4) and pixels.shape[2] not in _CHANNELS:
        pixels = np.moveaxis(pixels, 0, 2)
    if pixels.ndim not in (2, 3) or (pixels.ndim == 3 and pixels.shape[2] not in _CHANNELS):
        raise InputError(f"{name} of {source} has the shape {pixels.shape}: {WANTED}")
    return [_picture(pixels, name, source)]


def _picture(pixels: Pixels, name: str, source: str) -> Picture:
    if pixels.dtype.kind not in "buif":
        raise InputError(f"{name} of {source} holds {pixels.dtype}, no numbers: {WANTED}")
    if not pixels.size:
        raise InputError(f"{name} of {source} has the shape {pixels.shape} and no pixels: {WANTED}")
    if pixels.dtype.kind == "f" and not np.isfinite(pixels).all():
        raise InputError(
            f"{name} of {source} holds values that are not finite: replace them, "
            "as by np.nan_to_num(masks)"
        )
    return compact(Picture(pixels, name))


def _check_order(array: Pixels, source: str) -> None:
    """Refuse a stack whose frames are its last axis."""
    _, height, width = array.shape
    thin = max(height, width) > _THINNEST * min(height, width)
    if thin or _person_lies_across(array):
        raise InputError(
            f"{source} has the shape {array.shape}, and its frames do not come first: "
            "give np.moveaxis(masks, -1, 0)"
        )


def _person_lies_across(array: Pixels) -> bool:
    """Whether the first and last picture are blank, but the edges of all pictures are not.

    Of a stack (H, W, F) the first two axes begin and end with the blank margins of the pictures,
    and the last with two whole masks.
    """
    shown = array != array[0, 0, 0]
    margins = (shown[0], shown[-1], shown[:, 0], shown[:, -1])
    ends = (shown[:, :, 0], shown[:, :, -1])
    return bool(
        max(margin.mean() for margin in margins) < 0.002 and min(end.mean() for end in ends) > 0.02
    )
