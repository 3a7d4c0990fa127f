"""`Plane`: which values of a source's pictures tell the person: grey, alpha, indices or colours."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.silhouette.masks.picture import GREY_TOLERANCE, Picture, Pixels, grey_of

_MOST_COLOURS = 32  # of a label image

Extract = Callable[[Picture], Pixels]


@dataclass(frozen=True)
class Plane:
    """Where a picture's mask is.

    Attributes
    ----------
    name : str
        In words.
    of : callable
        From a picture to its values (H, W).
    labels : bool, default=False
        Whether the values are numbers that mean something by themselves.
    colours : bool, default=False
        Whether the values are distances from the background's colour.
    cut_out : bool, default=False
        Whether they are 1 where a picture differs from the background's one colour.
    """

    name: str
    of: Extract
    labels: bool = False
    colours: bool = False
    cut_out: bool = False


def choose_plane(pictures: Sequence[Picture], source: str, labels: bool = False) -> Plane:
    """Decide where the masks of a source are.

    Parameters
    ----------
    pictures : sequence of Picture
    source : str
        What the source is called in messages.
    labels : bool, default=False
        Whether the user has chosen labels, so that a palette's greys mean nothing.

    Raises
    ------
    InputError
        If kinds of pictures are mixed that have nothing in common.
    """
    if (alpha := _alpha(pictures)) is not None:
        return alpha
    if any(p.palette is not None for p in pictures):
        return _palette(pictures, source, labels)
    plain = [grey_of(p.pixels) for p in map(_without_alpha, pictures) if p.pixels.ndim == 3]
    if all(pixels.ndim == 2 for pixels in plain):
        return Plane("grey values", grey_or_colours)
    _check_odd_ones(pictures, source)
    return _colours(pictures)


def _alpha(pictures: Sequence[Picture]) -> Plane | None:
    """Take the alpha channel, if half of the pictures have one, and not all hide everything."""
    channels = [p.alpha for p in pictures if p.alpha is not None]
    if 2 * len(channels) < len(pictures) or not any(channel.any() for channel in channels):
        return None
    full = (
        channels[0].dtype.type(1 if channels[0].dtype.kind in "fb" else 0)
        or np.iinfo(channels[0].dtype).max
    )

    def of(picture: Picture) -> Pixels:
        channel = picture.alpha
        if channel is None:  # opaque alone is dropped when a picture is read
            return np.full(picture.pixels.shape[:2], full, channels[0].dtype)
        return channel

    return Plane("the alpha channel", of)


def _palette(pictures: Sequence[Picture], source: str, labels: bool) -> Plane:
    odd = [p.name for p in pictures if p.pixels.ndim == 3]
    if odd:
        raise InputError(f"'{odd[0]}' of {source} is in colours, others are indices of a palette")
    used = np.unique(
        np.concatenate([np.unique(_used_colours(p), axis=0) for p in pictures]), axis=0
    )
    count = len(np.unique(np.concatenate([np.unique(p.pixels) for p in pictures])))
    grey = (used == used[:, :1]).all() and len(used) == count
    if grey and not labels:
        return Plane("grey values of a palette", _grey_of_palette)
    return Plane("indices of a palette", lambda picture: picture.pixels, labels=True)


def _used_colours(picture: Picture) -> Pixels:
    indices = np.unique(picture.pixels)
    if picture.palette is None:
        return np.repeat(indices[:, None], 3, axis=1).astype(np.uint8)
    if not len(picture.palette) or indices.max() >= len(picture.palette):
        return np.zeros((1, 3), np.uint8)  # none to speak of
    return picture.palette[indices]


def _grey_of_palette(picture: Picture) -> Pixels:
    return picture.pixels if picture.palette is None else picture.palette[picture.pixels, 0]


def _without_alpha(picture: Picture) -> Picture:
    if picture.alpha is None:
        return picture
    return Picture(picture.pixels[:, :, :-1], picture.name, None, picture.lossy)


def grey_or_colours(picture: Picture) -> Pixels:
    """Return a picture's grey values (H, W), or its colours (H, W, 3) where these are not grey."""
    pixels = _without_alpha(picture).pixels
    return pixels if pixels.ndim == 2 else grey_of(pixels)


def _check_odd_ones(pictures: Sequence[Picture], source: str) -> None:
    """Refuse single pictures in colours among grey ones that show something."""
    grey = [p for p in pictures if p.grey and p.pixels.min() != p.pixels.max()]
    odd = [p for p in pictures if not p.grey]
    if len(odd) < len(grey):
        raise InputError(
            f"'{odd[0].name}' of {source} is in colours, and {len(grey)} others are masks: "
            "remove it, or segment it as the others"
        )


def _colours(pictures: Sequence[Picture]) -> Plane:
    """Numbers of colours, if they are few; else the distance from the background's colour."""
    few = _few_colours(pictures)
    if few is not None:
        order = ", ".join(f"{k} = {_in_words(colour)}" for k, colour in enumerate(few))
        return Plane(f"colours ({order})", partial(_numbered, few), labels=True)
    background = np.median([_border(picture) for picture in pictures], axis=0)
    return Plane(
        "the distance from the background's colour",
        lambda picture: _distance(picture, background),
        colours=True,
    )


def _few_colours(pictures: Sequence[Picture]) -> Pixels | None:
    found = np.zeros(0, np.int64)
    for picture in pictures:
        if picture.pixels.dtype != np.uint8 or picture.lossy:
            return None
        found = np.union1d(found, np.unique(_packed(picture)))
        if len(found) > _MOST_COLOURS:
            return None
    return found


def _numbered(few: Pixels, picture: Picture) -> Pixels:
    return np.searchsorted(few, _packed(picture))


def _rgb(picture: Picture) -> Pixels:
    pixels = _without_alpha(picture).pixels
    return np.repeat(pixels[:, :, None], 3, axis=2) if pixels.ndim == 2 else pixels


def _packed(picture: Picture) -> Pixels:
    red, green, blue = np.moveaxis(_rgb(picture).astype(np.int64), 2, 0)
    return red << 16 | green << 8 | blue


def _in_words(packed: int) -> str:
    return f"({packed >> 16}, {packed >> 8 & 255}, {packed & 255})"


def _border(picture: Picture) -> Array:
    rgb = _rgb(picture)
    edges = np.concatenate([rgb[0], rgb[-1], rgb[:, 0], rgb[:, -1]])
    return np.median(edges, axis=0).astype(float)


def _distance(picture: Picture, background: Array) -> Pixels:
    rgb = _rgb(picture)
    far = np.abs(rgb - background).max(axis=2)
    if rgb.dtype == np.uint8:
        return np.where(far > GREY_TOLERANCE, far, 0).astype(np.uint8)
    return far
