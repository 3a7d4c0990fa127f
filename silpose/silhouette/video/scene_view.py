"""`SceneView`: the detail of a scene without people, in which shifts are seen."""

from __future__ import annotations

from typing import NamedTuple, Self

import cv2
import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Array32, Mask
from silpose.silhouette.video.frame import Picture, reduced

_SIDE = 256  # pixels of the longer side at which pictures are compared
_SMOOTH = 0.06  # of it: what varies more slowly is light
_AROUND = 0.02  # of it: by which people are widened
_STRONG, _LEAST = 2.0, 2.0  # of the median detail, and grey levels: what is stronger counts so
_MOST = 0.5  # share of the picture that people cover, at most


class SceneView(NamedTuple):
    """One picture, reduced.

    Attributes
    ----------
    detail : ndarray of float32, shape (h, w)
        Grey levels without what varies slowly, strong edges clipped; 0 where people are.
    weight : ndarray of float32, shape (h, w)
        1 where the scene is seen, else 0.
    """

    detail: Array32
    weight: Array32

    @classmethod
    def of(cls, picture: Picture, people: Mask | None) -> Self:
        """Reduce a picture (H, W, 3), and leave out people (H, W)."""
        height, width = picture.shape[:2]
        scale = min(1.0, _SIDE / max(height, width))
        size = max(8, round(scale * width)), max(8, round(scale * height))
        grey = cv2.cvtColor(reduced(picture, *size), cv2.COLOR_RGB2GRAY).astype(np.float32)
        seen = np.ones_like(grey)
        if people is not None and people.any():
            own = cv2.resize(people, size, interpolation=cv2.INTER_NEAREST)
            around = 2 * round(_AROUND * max(size)) + 1
            own = cv2.dilate(own, np.ones((around, around), np.uint8))
            if own.mean() < _MOST:
                seen = (1 - own).astype(np.float32)
        wide = 2 * round(_SMOOTH * max(size)) + 1
        usual = cv2.blur(seen * grey, (wide, wide)) / np.maximum(cv2.blur(seen, (wide, wide)), 1e-3)
        detail = grey - usual
        most = max(_STRONG * float(np.median(np.abs(detail))), _LEAST)
        return cls(np.asarray(seen * np.clip(detail, -most, most), np.float32), seen)

    def compared(self, other: Self, shift: NDArray[np.floating]) -> tuple[Array32, Array32]:
        """Compare with another view that is shifted back.

        Parameters
        ----------
        other : SceneView
        shift : ndarray, shape (2,)
            Pixels to the right and down by which the scene is shifted in the other view.

        Returns
        -------
        moved : ndarray, shape (h, w)
            The other's detail, shifted back.
        weight : ndarray, shape (h, w)
            1 where both see the scene.
        """
        if not shift.any():
            return other.detail, self.weight * other.weight
        height, width = self.detail.shape
        back = np.array([[1, 0, shift[0]], [0, 1, shift[1]]], float)
        how = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
        moved, seen = (cv2.warpAffine(own, back, (width, height), flags=how) for own in other)
        _, whole = cv2.threshold(seen, 0.99, 1.0, cv2.THRESH_BINARY)
        return np.asarray(moved, np.float32), self.weight * np.asarray(whole, np.float32)


def gradient(detail: Array32, weight: Array32) -> tuple[Array32, Array32]:
    """Slopes of detail (h, w) across and down; 0 beside what has no weight."""
    inside = cv2.erode(weight, np.ones((3, 3), np.uint8))
    across, down = (
        np.asarray(inside * cv2.Sobel(detail, cv2.CV_32F, dx, 1 - dx, ksize=3, scale=1 / 8))
        for dx in (1, 0)
    )
    return across, down
