"""`Threshold`: which brightness separates the person from the background."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Array, Indices, Mask
from silpose.silhouette.masks.levels import Levels
from silpose.silhouette.masks.picture import Pixels

_SHADOW = (115, 140)  # of 255: where background subtraction marks shadows, 127 of itself
_BRIGHT = 205  # of 255: what is a person beside a shadow
_SOLID = 0.01  # least share of the person's pixels that a level of its own has
_EDGE = 0.6  # greatest share of a level's pixels that may lie on edges
_NEAR = 0.15  # of the span: distance from a level within which compression leaves its pixels
_MASK = 0.85  # least share of flat pixels near a level
_PERSON = 0.6  # least share of flat pixels near the person's level, of those off the background's
_AREAS = 0.1  # least share of flat pixels; of noise there are none
_ENOUGH = 20  # pixels, and 1 % of a picture, to judge a person by
_AROUND = np.ones((3, 3), np.uint8)
_NARROWEST = 30  # of 255: span below which a compressed picture shows nothing


@dataclass(frozen=True)
class Threshold:
    """What is above a value is the person, or, inverted, what is below.

    Attributes
    ----------
    value : float
        In the units of the source.
    inverted : bool
    """

    value: float
    inverted: bool = False

    def apply(self, plane: Pixels) -> Mask:
        """Separate the person from the background."""
        person = plane <= self.value if self.inverted else plane > self.value
        return person.view(np.uint8)


def solid_levels(levels: Levels) -> Array:
    """Find the values that fill areas of their own, not edges between others.

    Parameters
    ----------
    levels : Levels

    Returns
    -------
    values : ndarray
        Increasing, the least and the greatest value among them.
    """
    present = np.flatnonzero(levels.count)
    background = levels.count.max()
    person = max(int(levels.count.sum() - background), 1)
    share, edges = levels.count / person, levels.between / np.maximum(levels.count, 1)
    solid = (share > _SOLID) & (edges < _EDGE) & (levels.flat > 0)
    solid[present[[0, -1]]] = True
    return levels.values[solid & (levels.count > 0)]


def is_shadow(values: Array) -> bool:
    """Whether of three levels the middle one is the shadow of background subtraction."""
    return bool(len(values) == 3 and _SHADOW[0] < values[1] < _SHADOW[1] and values[2] == 255)


def shadow_of(levels: Levels) -> float | None:
    """Find the shadow's grey of background subtraction among values that compression changed."""
    flat, values = levels.nearly_flat.sum(axis=0), levels.values
    high = levels.present[-1]
    middle = (values > _SHADOW[0]) & (values < _SHADOW[1])
    beside = ((values > 60) & (values <= 85)) | ((values >= 170) & (values < 195))
    person = flat[values > _BRIGHT].sum()
    if not levels.exact or not _BRIGHT < high <= 255:
        return None
    if flat[middle].sum() > max(0.01 * person, 4 * flat[beside].sum(), 20):
        return float(np.average(values[middle], weights=flat[middle]))
    return None


def surrounds(planes: Sequence[Pixels], values: Array) -> bool:
    """Whether the middle of three values always lies between the others, as in a trimap."""
    touching = edge = 0
    for plane in planes:
        low = cv2.erode(plane, _AROUND)
        person = plane == values[2]
        touching += int((low[person] <= values[0]).sum())
        edge += int((low[person] < values[2]).sum())
    return edge > 0 and touching < 0.02 * edge


def shows_nothing(levels: Levels) -> bool:
    """Whether values that compression changed differ too little to show a person."""
    low, high = levels.present[[0, -1]]
    return bool(high - low < _NARROWEST)


def two_levels(levels: Levels) -> tuple[float, float]:
    """Find the usual values of dark and of bright areas; the outermost where there are none."""
    low, high = levels.present[[0, -1]]
    flat = levels.nearly_flat.sum(axis=0)
    bright = levels.values > (low + high) / 2
    return _median(levels.values, flat * ~bright, low), _median(levels.values, flat * bright, high)


def _median(values: Array, counts: Indices, otherwise: float) -> float:
    total = np.cumsum(counts)
    return float(values[np.searchsorted(total, total[-1] / 2)] if total[-1] else otherwise)


def like_masks(levels: Levels, shadow: float | None) -> NDArray[np.bool_]:
    """Whether the flat pixels of each picture are near two levels, as in masks, not in photos.

    Returns
    -------
    like : ndarray of bool, shape (F,)
    """
    low, high = two_levels(levels)
    dark = bright_border(levels, (low + high) / 2) > 0.5
    background, person = (high, low) if dark else (low, high)
    near = [np.abs(levels.values - v) < _NEAR * (high - low) for v in (background, person)]
    shaded = np.zeros_like(near[0])
    if shadow is not None:
        shaded = np.abs(levels.values - shadow) < _NEAR / 2 * (high - low)
    flat = levels.nearly_flat
    total = flat.sum(axis=1)
    behind, own, shade = (flat[:, which].sum(axis=1) for which in (*near, shaded))
    off = total - behind - shade
    known = (behind + own + shade >= _MASK * total) & (behind + own >= total / 2)
    person_known = (own >= _PERSON * off) | (off < _ENOUGH + 0.01 * total)
    pixels = levels.by_picture
    mostly = pixels[:, near[0] | near[1] | shaded].sum(axis=1) >= pixels.sum(axis=1) / 2
    areas = total >= _AREAS * pixels.sum(axis=1)
    constant = (pixels > 0).sum(axis=1) == 1
    return constant | (areas & mostly & known & person_known)


def bright_border(levels: Levels, threshold: float) -> float:
    """Share of the pictures' borders that is bright, the upper border counted twice.

    The person may leave the picture anywhere, but seldom through its upper border.
    """
    bright = levels.values > threshold
    shares = [edge[bright].sum() / max(edge.sum(), 1) for edge in (levels.border, levels.top)]
    return float(np.mean(shares))
