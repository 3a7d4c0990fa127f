"""`PackedMask`: a mask in a small part of its memory, for as many as a film has."""

from __future__ import annotations

from typing import NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Mask


class PackedMask(NamedTuple):
    """The box around a mask's foreground, a bit a pixel.

    Attributes
    ----------
    shape : tuple of int
        Height and width of the mask.
    box : tuple of int
        Left, top, width and height, pixels.
    bits : ndarray of uint8
    """

    shape: tuple[int, int]
    box: tuple[int, int, int, int]
    bits: NDArray[np.uint8]

    @classmethod
    def of(cls, mask: Mask) -> PackedMask:
        """Pack a mask of 0 and 1, shape (H, W)."""
        left, top, width, height = cv2.boundingRect(mask)
        inside = mask[top : top + height, left : left + width]
        shape = (mask.shape[0], mask.shape[1])
        return cls(shape, (left, top, width, height), np.packbits(inside))

    @property
    def mask(self) -> Mask:
        """The mask itself."""
        left, top, width, height = self.box
        mask = np.zeros(self.shape, np.uint8)
        inside = np.unpackbits(self.bits, count=width * height).reshape(height, width)
        mask[top : top + height, left : left + width] = inside
        return mask
