"""`Picture`: one frame of a source as it was stored, before it is known what its pixels mean."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Pixels = NDArray[Any]

GREY_TOLERANCE = 12
"""Difference of colour channels, of 255, that compression makes of grey."""


@dataclass(frozen=True)
class Picture:
    """Pixels of one frame.

    Attributes
    ----------
    pixels : ndarray, shape (H, W) or (H, W, C)
        Of any number type; two channels are grey and alpha, three are colours, four colours and
        alpha.
    name : str
        What it is called in messages.
    palette : ndarray of uint8, shape (n, 3), or None, default=None
        Colours, where the pixels are indices of them.
    lossy : bool, default=False
        Whether compression may have changed values.
    """

    pixels: Pixels
    name: str
    palette: Pixels | None = None
    lossy: bool = False

    @property
    def grey(self) -> bool:
        """Whether pixels are single values that are no indices."""
        return self.pixels.ndim == 2 and self.palette is None

    @property
    def alpha(self) -> Pixels | None:
        """The alpha channel, if there is one."""
        has_alpha = self.pixels.ndim == 3 and self.pixels.shape[2] in (2, 4)
        return self.pixels[:, :, -1] if has_alpha else None


def compact(picture: Picture) -> Picture:
    """Reduce colours that are grey to one channel, and drop an alpha channel that is opaque."""
    pixels = picture.pixels
    if pixels.ndim != 3:
        return picture
    if picture.alpha is not None:
        if not is_opaque(picture.alpha):
            return picture
        pixels = pixels[:, :, :-1]
    pixels = grey_of(pixels)
    return Picture(np.ascontiguousarray(pixels), picture.name, picture.palette, picture.lossy)


def is_opaque(alpha: Pixels) -> bool:
    """Whether an alpha channel is at its highest value everywhere."""
    lowest = alpha.min()
    if alpha.dtype.kind == "f":
        return bool(lowest >= 1 and lowest == alpha.max())
    return bool(lowest == (1 if alpha.dtype == bool else np.iinfo(alpha.dtype).max))


def grey_of(pixels: Pixels) -> Pixels:
    """Return the one channel of colours (H, W, C) that are grey, else the colours."""
    if pixels.shape[2] == 1:
        return pixels[:, :, 0]
    if pixels.dtype == bool or pixels.dtype.kind == "f":
        same = (pixels == pixels[:, :, :1]).all()
        return pixels[:, :, 0] if same else pixels
    red, green, blue = (pixels[:, :, k] for k in range(3))
    if np.array_equal(red, green) and np.array_equal(green, blue):
        return red
    widest = pixels.max(axis=2) - pixels.min(axis=2)
    return green if widest.max() <= GREY_TOLERANCE and pixels.max() > 4 * GREY_TOLERANCE else pixels
