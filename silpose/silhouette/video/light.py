"""`Light`: how much brighter a scene is than its background was, smoothly over the picture."""

from __future__ import annotations

import cv2
import numpy as np

from silpose.core.types import Array, Array32
from silpose.silhouette.video.frame import Picture, reduced

_GRID = 48  # cells along the longer side, of which each has one brightness
_OFFSET = 8.0  # grey levels added to both, so that noise of dark cells is no ratio
_FLAT = 0.02  # log of a ratio below which light is as it was
_SAME = 0.01  # change of that log up to which the gain of before is good enough
_JUMP = 0.1  # change of that log within a frame, from which a light was switched
_ROUNDS = 4
_STIFFNESS = 1e-3  # of the surface's bending, relative to its data


class Light:
    """Compares the brightness of pictures with that of a background.

    The logarithm of their ratio is a surface of second order in each colour, fitted robustly, so
    that a person is left out and a lamp at one side is allowed.

    Parameters
    ----------
    background : ndarray of uint8, shape (H, W, 3)
    """

    def __init__(self, background: Picture) -> None:
        height, width = background.shape[:2]
        scale = min(1.0, _GRID / max(height, width))
        self._grid = max(3, round(scale * width)), max(3, round(scale * height))
        columns, rows = np.meshgrid(
            np.linspace(-1, 1, self._grid[0]), np.linspace(-1, 1, self._grid[1])
        )
        x, y = columns.ravel(), rows.ravel()
        self._terms = np.stack([np.ones_like(x), x, y, x * y, x * x, y * y], axis=1)
        self._background = self._logs(background)
        self._before: Array | None = None
        self._given: Array | None = None
        self._gain: Array32 | None = None

    def step(self, picture: Picture) -> tuple[Array32 | None, bool]:
        """Compare the next picture.

        Parameters
        ----------
        picture : ndarray of uint8, shape (H, W, 3)

        Returns
        -------
        gain : ndarray of float32, shape (H, W, 3), or None
            What the background is to be multiplied by; None if light is as it was. The same
            array as before, as long as it is good enough.
        switched : bool
            Whether a light was switched since the picture before.
        """
        surface = self._fit(self._logs(picture) - self._background)
        before, self._before = self._before, surface
        switched = before is not None and float(np.abs(surface - before).mean()) > _JUMP
        if np.abs(surface).max() < _FLAT:
            self._gain = self._given = None
            return None, switched
        if self._given is not None and np.abs(surface - self._given).max() < _SAME:
            return self._gain, switched
        columns, rows = self._grid
        gain = np.exp(surface).reshape(rows, columns, 3).astype(np.float32)
        size = picture.shape[1], picture.shape[0]
        self._given = surface
        self._gain = np.asarray(cv2.resize(gain, size, interpolation=cv2.INTER_LINEAR), np.float32)
        return self._gain, switched

    def _logs(self, picture: Picture) -> Array:
        small = reduced(picture, *self._grid)
        return np.log(small.reshape(-1, 3).astype(np.float64) + _OFFSET)

    def _fit(self, logs: Array) -> Array:
        """Fit the surface to cells (C, 3), without those that are off in any colour."""
        off = np.abs(logs - np.median(logs, axis=0)).max(axis=1)
        coefficients = np.zeros((6, 3))
        stiff = np.diag([0.0, *[_STIFFNESS * len(logs)] * 5])
        for _ in range(_ROUNDS):
            spread = max(2.5 * float(np.median(off)), _FLAT)
            weights = np.clip(1 - (off / (2 * spread)) ** 2, 0, None) ** 2
            weighted = self._terms * weights[:, None]
            coefficients = np.linalg.solve(self._terms.T @ weighted + stiff, weighted.T @ logs)
            off = np.abs(logs - self._terms @ coefficients).max(axis=1)
        return np.asarray(self._terms @ coefficients)


def lit(picture: Picture, gain: Array32 | None) -> Picture:
    """Multiply a picture by a gain, between 0 and 255."""
    if gain is None:
        return picture
    return np.asarray(cv2.multiply(picture, gain, dtype=cv2.CV_8U), np.uint8)
