"""`Levels`: the values of a source's pixels, and how pixels of each value lie beside others."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from silpose.core.types import Array, Indices, Mask
from silpose.silhouette.masks.picture import Pixels

_VALUES = 256  # told apart; of more, equal steps are
_NEARLY = 20  # of 256: values that differ less are flat in a picture that compression changed
_AROUND = np.ones((3, 3), np.uint8)


@dataclass(frozen=True)
class Levels:
    """Counts of pixels by value, over all pictures of a source.

    Attributes
    ----------
    values : ndarray, shape (n,)
        Increasing, in the units of the source.
    exact : bool
        Whether they are the source's own values, and not steps between its least and its greatest.
    count : ndarray of int, shape (n,)
    by_picture : ndarray of int, shape (F, n)
        Pixels of each picture.
    flat : ndarray of int, shape (n,)
        Pixels whose neighbours have the same value.
    nearly_flat : ndarray of int, shape (F, n)
        Pixels of each picture whose neighbours have nearly the same value.
    between : ndarray of int, shape (n,)
        Pixels with both a lesser and a greater value beside them, as on soft edges.
    border : ndarray of int, shape (n,)
        Pixels on the border of a picture, of pictures that have several values.
    top : ndarray of int, shape (n,)
        Likewise on the upper border.
    """

    values: Array
    exact: bool
    count: Indices
    by_picture: Indices
    flat: Indices
    nearly_flat: Indices
    between: Indices
    border: Indices
    top: Indices

    @classmethod
    def of(cls, planes: Sequence[Pixels]) -> Levels:
        """Count the pixels of pictures (H, W)."""
        values, exact, codes = _encoded(planes)
        counts: Indices = np.zeros((4, _VALUES), np.intp)
        flat, between, border, top = counts
        by_picture: Indices = np.zeros((len(planes), _VALUES), np.intp)
        nearly_flat = np.zeros_like(by_picture)
        for frame, code in enumerate(codes):
            found = _histogram_of_picture(code)
            by_picture[frame] = found
            present = np.flatnonzero(found)
            if len(present) == 1:
                continue
            border += _histogram(np.concatenate([code[0], code[-1], code[:, 0], code[:, -1]]))
            top += _histogram(code[0])
            if len(present) == 2 and exact:  # nothing is between two values
                flat += found
                nearly_flat[frame] = found
                continue
            low, high = cv2.erode(code, _AROUND), cv2.dilate(code, _AROUND)
            between += _histogram(code[(low < code) & (code < high)])
            flat += _histogram(code[low == high])
            nearly_flat[frame] = _histogram(code[high - low <= _NEARLY])
        n = len(values)
        flat, between, border, top = counts[:, :n]
        by_picture, nearly_flat = by_picture[:, :n], nearly_flat[:, :n]
        count: Indices = by_picture.sum(axis=0)
        return cls(values, exact, count, by_picture, flat, nearly_flat, between, border, top)

    @property
    def present(self) -> Array:
        """The values that occur."""
        return self.values[self.count > 0]


def _histogram(codes: Mask) -> Indices:
    return np.bincount(codes.ravel(), minlength=_VALUES)


def _histogram_of_picture(code: Mask) -> Indices:
    """Count each value, shape (256,): two values, as most masks have, in a third of the time."""
    counts = np.zeros(_VALUES, np.intp)
    for value in {int(code.min()), int(code.max())}:
        counts[value] = np.count_nonzero(code == value)
    return counts if counts.sum() == code.size else _histogram(code)


def _encoded(planes: Sequence[Pixels]) -> tuple[Array, bool, list[Mask]]:
    """Write the values of pictures as numbers 0 to 255 that stand for them."""
    if all(plane.dtype == np.uint8 for plane in planes):
        return (
            np.arange(_VALUES, dtype=float),
            True,
            [np.ascontiguousarray(plane) for plane in planes],
        )
    if all(plane.dtype == bool for plane in planes):
        return np.arange(2, dtype=float), True, [plane.astype(np.uint8) for plane in planes]
    own: Array = np.zeros(0)
    for plane in planes:
        own = np.union1d(own, np.unique(plane).astype(float))
        if len(own) > _VALUES:
            break
    else:
        return own, True, [np.searchsorted(own, plane).astype(np.uint8) for plane in planes]
    low = min(float(plane.min()) for plane in planes)
    step = (max(float(plane.max()) for plane in planes) - low) / (_VALUES - 1)
    steps = low + step * np.arange(_VALUES, dtype=np.float64)
    return steps, False, [np.rint((plane - low) / step).astype(np.uint8) for plane in planes]
