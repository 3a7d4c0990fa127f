"""Degradations by what a person wears or carries.

Their place is relative to the person's height and to the middle of the trunk, not to the bounding
box, whose width changes with every step: drawn once for a take, they stay on the person.
"""

from __future__ import annotations

import cv2
import numpy as np

from silpose.core.types import Mask
from silpose.silhouette.box import Box

_WAIST, _SHOULDERS = 0.4, 0.18  # of the height, from the top


def bag(mask: Mask, box: Box, strength: float, rng: np.random.Generator) -> Mask:
    """Carry a bag at the hip or on the back: at 1, it is a quarter of the height tall."""
    side, on_back = rng.choice([-1, 1]), rng.random() < 0.5
    down = rng.uniform(0.25, 0.4) if on_back else rng.uniform(0.5, 0.65)
    away, slim = rng.uniform(0.1, 0.15), rng.uniform(0.6, 0.9)
    middle = (
        round(_middle(mask, box) + side * away * box.height),
        round(box.top + down * box.height),
    )
    tall = strength * box.height / 4
    carried = mask.copy()
    cv2.ellipse(carried, middle, (round(slim * tall / 2), round(tall / 2)), 0, 0, 360, 1, -1)
    return carried


def coat(mask: Mask, box: Box, strength: float, rng: np.random.Generator) -> Mask:
    """Wear a coat or a skirt: at 1, it reaches the ankles and stands off by a 25th of the height.

    From the waist it falls straight to where the legs are at its hem.
    """
    hem = min(box.bottom - 1, round(box.top + (0.5 + 0.4 * strength) * box.height))
    waist = round(box.top + _WAIST * box.height)
    ease, flare = strength * box.height / 25, rng.uniform(0.0, 1.5)
    top = round(box.top + (_SHOULDERS if rng.random() < 0.5 else _WAIST) * box.height)
    legs = np.flatnonzero(mask[max(waist, hem - max(1, box.height // 12)) : hem + 1].any(axis=0))
    if not len(legs):
        return mask.copy()
    near = np.asarray(cv2.distanceTransform(1 - mask, cv2.DIST_L2, 3))
    wide = (near <= ease).astype(np.uint8)
    wide[:top], wide[hem + 1 :] = 0, 0
    middle, half = _middle(mask, box), 0.09 * box.height
    outline = np.array(
        [
            [middle - half, waist],
            [middle + half, waist],
            [max(middle + half, legs[-1]) + flare * ease, hem],
            [min(middle - half, legs[0]) - flare * ease, hem],
        ]
    )
    worn = mask | wide
    if strength > 0:
        cv2.fillConvexPoly(worn, outline.round().astype(np.int32), 1)
    return worn


def _middle(mask: Mask, box: Box) -> float:
    """Column in the middle of the trunk."""
    upper = mask[box.top : box.top + max(1, box.height // 2)]
    columns = np.flatnonzero(upper.any(axis=0))
    weights = upper[:, columns].sum(axis=0, dtype=float)
    return float((columns * weights).sum() / weights.sum())
