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
_LOGS = np.log(np.arange(256) + _OFFSET)
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
        self._terms = np.stack([np.ones_like(x), x, y, x * y, x * x, y * y])
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
        gain = np.exp(surface.T).reshape(rows, columns, 3).astype(np.float32)
        size = picture.shape[1], picture.shape[0]
        self._given = surface
        self._gain = np.asarray(cv2.resize(gain, size, interpolation=cv2.INTER_LINEAR), np.float32)
        return self._gain, switched

    def _logs(self, picture: Picture) -> Array:
        """Log of each colour's brightness, cell by cell, shape (3, C)."""
        small = reduced(picture, *self._grid)
        return np.ascontiguousarray(_LOGS[small.reshape(-1, 3)].T)

    def _fit(self, logs: Array) -> Array:
        """Fit the surface to cells (3, C), without those that are off in any colour."""
        off = _farthest(logs - np.stack([_median(own) for own in logs])[:, None])
        coefficients = np.zeros((3, 6))
        stiff = np.diag([0.0, *[_STIFFNESS * logs.shape[1]] * 5])
        for _ in range(_ROUNDS):
            spread = max(2.5 * _median(off), _FLAT)
            weighted = self._terms * np.square(np.maximum(1 - np.square(off / (2 * spread)), 0))
            gram = weighted @ self._terms.T + stiff
            coefficients = np.linalg.solve(gram, weighted @ logs.T).T
            off = _farthest(logs - coefficients @ self._terms)
        return np.asarray(coefficients @ self._terms)


def _median(values: Array) -> float:
    """Median of values (C,), which of so few takes NumPy's function five times as long."""
    half = len(values) // 2
    below, above = np.partition(values, [half - 1, half])[half - 1 : half + 1]
    return float(above if len(values) % 2 else (below + above) / 2)


def _farthest(off: Array) -> Array:
    """Largest of three absolute differences (3, C), shape (C,)."""
    one, two, three = np.abs(off)
    return np.asarray(np.maximum(np.maximum(one, two), three))


def lit(picture: Picture, gain: Array32 | None) -> Picture:
    """Multiply a picture by a gain, between 0 and 255."""
    if gain is None:
        return picture
    return np.asarray(cv2.multiply(picture, gain, dtype=cv2.CV_8U), np.uint8)
