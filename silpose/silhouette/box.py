"""The rectangle that a person covers in a mask."""

from __future__ import annotations

from dataclasses import dataclass

import cv2

from silpose.core.types import Mask


@dataclass(frozen=True)
class Box:
    """Rows and columns that a person covers, pixels, the last ones excluded."""

    top: int
    bottom: int
    left: int
    right: int

    @classmethod
    def of(cls, mask: Mask) -> Box:
        """Bounding box of a mask's foreground."""
        left, top, width, height = cv2.boundingRect(mask)
        return cls(top, top + height, left, left + width)

    @property
    def height(self) -> int:
        """Height of the person, pixels."""
        return self.bottom - self.top

    @property
    def width(self) -> int:
        """Width of the person, pixels."""
        return self.right - self.left
