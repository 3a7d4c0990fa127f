"""`CameraMotion`: whether a camera that should stand still moves."""

from __future__ import annotations

import cv2
import numpy as np

from silpose.core.types import Array32
from silpose.silhouette.video.frame import Picture, reduced

_SIDE = 256  # pixels of the longer side at which pictures are compared
_CELLS = 6  # along the longer side
_TEXTURE = 4.0  # standard deviation, grey levels, below which a cell shows no shift
_CLEAR = 0.15  # response of phase correlation below which a cell shows no shift
_ALIKE = 0.75  # pixels by which cells' shifts may differ and still be one motion
_SHARE = 0.6  # of the cells with texture that must agree
_FEWEST = 3
_MANY, _FEW, _LIKE = 6, 0.3, 0.4  # cells with texture; share of them; correlation: the same scene


class CameraMotion:
    """Compares pictures with the first one, or with one of a while ago, cell by cell.

    A person shifts a few cells, each in a way of its own; a camera shifts all of them alike.

    Parameters
    ----------
    shift : float
        Share of the longer side from which a shift is a motion.
    renew : int or None, default=None
        Pictures after which the reference is replaced; None keeps the first one.
    """

    def __init__(self, shift: float, renew: int | None = None) -> None:
        self.shift = shift
        self.renew = renew
        self._reference: Array32 | None = None
        self._age = 0
        self._moved = False

    def step(self, picture: Picture) -> bool:
        """Whether the camera has moved since the reference; as before, where nothing tells."""
        grey = self._small(picture)
        self._age += 1
        if self._reference is None:
            self._reference = grey
            return False
        shifts, likeness = self._compare(self._reference, grey)
        if self.renew is not None and self._age >= self.renew:
            self._reference, self._age = grey, 0
        if len(likeness) >= _MANY and (likeness > _LIKE).mean() < _FEW:
            self._moved = True  # so far that no cell shows the same
        elif len(shifts) >= _FEWEST:
            middle = np.median(shifts, axis=0)
            far = float(np.hypot(*middle))
            alike = np.hypot(*(shifts - middle).T) <= max(_ALIKE, 0.2 * far)
            if alike.sum() >= max(_FEWEST, _SHARE * len(shifts)):
                self._moved = far > self.shift * max(grey.shape)
        return self._moved

    def _small(self, picture: Picture) -> Array32:
        height, width = picture.shape[:2]
        scale = min(1.0, _SIDE / max(height, width))
        size = max(8, round(scale * width)), max(8, round(scale * height))
        small = reduced(picture, *size)
        return np.asarray(cv2.cvtColor(small, cv2.COLOR_RGB2GRAY), np.float32)

    def _compare(self, one: Array32, other: Array32) -> tuple[Array32, Array32]:
        """Shifts of cells that show one (S, 2), pixels; correlation of each with texture."""
        height, width = one.shape
        side = max(8, max(height, width) // _CELLS)
        window = np.asarray(cv2.createHanningWindow((side, side), cv2.CV_32F), np.float32)
        shifts, likeness = [], []
        for top in range(0, height - side + 1, side):
            for left in range(0, width - side + 1, side):
                part = slice(top, top + side), slice(left, left + side)
                a, b = (np.ascontiguousarray(p[part] - p[part].mean()) for p in (one, other))
                if min(a.std(), b.std()) < _TEXTURE:
                    continue
                likeness.append(float((a * b).mean() / (a.std() * b.std())))
                shift, response = cv2.phaseCorrelate(a, b, window)
                if response >= _CLEAR:
                    shifts.append(shift)
        return np.asarray(shifts, np.float32).reshape(-1, 2), np.asarray(likeness, np.float32)
