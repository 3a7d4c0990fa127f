"""Degradations of silhouettes: segmentation errors, occluders, shadows, clothes, a frame's edge.

Each kind of degradation has a strength from 0 (nothing happens) to 1, whose meaning its function
states relative to the person, so that it is the same at any resolution. Where hardly anything would
be left of the person, the strength is halved until enough is left: a degraded mask is never blank
unless it was blank before.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import cv2
import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.core.types import Array32, Mask
from silpose.silhouette.box import Box
from silpose.silhouette.worn import bag, coat

LEAST = 0.05
"""Share of the person that is always left."""


def degrade(mask: Mask, kind: str, strength: float, rng: np.random.Generator) -> Mask:
    """Degrade one mask.

    Parameters
    ----------
    mask : ndarray of 0 and 1, shape (H, W)
    kind : str
        One of `DEGRADATIONS`.
    strength : float
        0 to 1.
    rng : numpy.random.Generator
        Draws places, sides and shapes.

    Returns
    -------
    degraded : ndarray of 0 and 1, shape (H, W)
        A copy. A blank mask stays blank; of any other at least a twentieth of its pixels is left.

    Raises
    ------
    InputError
        If there is no such kind, or the strength is outside 0 to 1.
    """
    check(kind, strength)
    area = cv2.countNonZero(mask)
    state = rng.bit_generator.state
    while area > 0 and strength > 1e-3:
        degraded = DEGRADATIONS[kind](mask, Box.of(mask), strength, rng)
        if cv2.countNonZero(degraded & mask) >= max(1, LEAST * area):
            return degraded
        strength /= 2
        rng.bit_generator.state = state  # the same damage, but weaker
    return mask.copy()


def check(kind: str, strength: float) -> None:
    """Refuse an unknown kind, and strengths outside 0 to 1."""
    if kind not in DEGRADATIONS:
        raise InputError(f"there is no degradation '{kind}'; there are {', '.join(DEGRADATIONS)}")
    if not 0 <= strength <= 1:
        raise InputError(f"a degradation's strength must be from 0 to 1, not {strength}")


def contour_damage(mask: Mask, degraded: Mask) -> float:
    """Share of the true contour that is lost, or of the observed one that is false.

    A contour pixel is lost, or false, if the other mask's contour is farther away than a hundredth
    of the person's height.

    Parameters
    ----------
    mask, degraded : ndarray of 0 and 1, shape (H, W)

    Returns
    -------
    damage : float
        The larger of the two shares; 0 for two blank masks, 1 if only one is blank.
    """
    contours = [_contour(m) for m in (mask, degraded)]
    if not all(c.any() for c in contours):
        return float(any(c.any() for c in contours))
    tolerance = max(1.0, Box.of(mask).height / 100)
    away = [cv2.distanceTransform((~c).astype(np.uint8), cv2.DIST_L2, 3) for c in contours]
    return max(float(np.mean(away[1 - k][contours[k]] > tolerance)) for k in (0, 1))


def _contour(mask: Mask) -> NDArray[np.bool_]:
    inner = cv2.erode(mask, np.ones((3, 3), np.uint8), borderType=cv2.BORDER_CONSTANT)
    return mask > np.asarray(inner)


def boundary_noise(mask: Mask, box: Box, strength: float, rng: np.random.Generator) -> Mask:
    """Fray the outline: at 1, displacements have a standard deviation of a 30th of the height."""
    inside = cv2.distanceTransform(mask, cv2.DIST_L2, 3)
    outside = cv2.distanceTransform(1 - mask, cv2.DIST_L2, 3)
    noise = cv2.GaussianBlur(rng.standard_normal(mask.shape), (0, 0), max(box.height / 60, 0.5))
    deviation = strength * box.height / 30
    displacement = noise * (deviation / max(float(np.std(noise)), 1e-9))
    return (inside - outside + displacement > 0).astype(np.uint8)


def holes(mask: Mask, box: Box, strength: float, rng: np.random.Generator) -> Mask:
    """Punch round holes: at 1, half of the person is gone."""
    degraded = mask.copy()
    area = cv2.countNonZero(mask)
    person = np.argwhere(mask)
    while cv2.countNonZero(degraded) > (1 - strength / 2) * area:
        y, x = person[rng.integers(len(person))]
        radius = round(box.height * rng.uniform(0.015, 0.05))
        cv2.circle(degraded, (int(x), int(y)), radius, 0, -1)
    return degraded


def missing_limb(mask: Mask, box: Box, strength: float, rng: np.random.Generator) -> Mask:
    """Cut off an arm, a leg or the head: at 1 all of it, at 0.5 its outer half."""
    limb, reach = _limb(mask, box, rng)
    beyond = limb & (reach > (1 - strength) * reach[limb].max(initial=0))
    return mask * ~beyond


def swollen_limb(mask: Mask, box: Box, strength: float, rng: np.random.Generator) -> Mask:
    """Thicken an arm, a leg or the head, as loose clothes do: at 1, by a 15th of the height."""
    limb, _ = _limb(mask, box, rng)
    far = cv2.distanceTransform((~limb).astype(np.uint8), cv2.DIST_L2, 3)
    return mask | (far <= strength * box.height / 15).astype(np.uint8)


def shadow(mask: Mask, box: Box, strength: float, rng: np.random.Generator) -> Mask:
    """Add a shadow on the ground, from the feet: at 1, as long as the person is tall."""
    side = rng.choice([-1, 1]) * rng.uniform(0.7, 1.0)
    up = rng.uniform(0.15, 0.35)  # the ground rises in the image with the distance
    cast = np.array(
        [
            [1, -side * strength, side * strength * box.bottom],
            [0, up * strength, (1 - up * strength) * box.bottom],
        ]
    )
    height, width = mask.shape
    flat = cv2.warpAffine(mask, cast, (width, height))
    closed = cv2.morphologyEx(flat, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8))
    return mask | np.asarray(closed, np.uint8)


def horizontal_occluder(mask: Mask, box: Box, strength: float, rng: np.random.Generator) -> Mask:
    """Hide a horizontal band, as a fence does: at 1, half of the person's height."""
    band = max(1, round(strength * box.height / 2))
    start = rng.integers(box.top, max(box.bottom - band, box.top) + 1)
    degraded = mask.copy()
    degraded[start : start + band] = 0
    return degraded


def vertical_occluder(mask: Mask, box: Box, strength: float, rng: np.random.Generator) -> Mask:
    """Hide a vertical band, as a lamp post does: at 1, half of the person's width."""
    band = max(1, round(strength * box.width / 2))
    start = rng.integers(box.left, max(box.right - band, box.left) + 1)
    degraded = mask.copy()
    degraded[:, start : start + band] = 0
    return degraded


def low_resolution(mask: Mask, box: Box, strength: float, rng: np.random.Generator) -> Mask:
    """Lower the resolution, as from afar: at 1, 12 blocks make the person's height."""
    block = max(1.0, strength * box.height / 12)
    height, width = mask.shape
    small = (max(1, round(width / block)), max(1, round(height / block)))
    coarse = cv2.resize(mask * 255, small, interpolation=cv2.INTER_AREA)
    grown = cv2.resize(coarse, (width, height), interpolation=cv2.INTER_NEAREST)
    return (grown > 127).astype(np.uint8)


def frame_cut(mask: Mask, box: Box, strength: float, rng: np.random.Generator) -> Mask:
    """Crop the image within the person, at feet, head or a side: at 1, half is outside."""
    degraded = mask.copy()
    rows, columns = (round(strength * side / 2) for side in (box.height, box.width))
    side = rng.choice(["feet", "head", "left", "right"], p=[0.4, 0.2, 0.2, 0.2])
    if side == "feet":
        degraded[box.bottom - rows :] = 0
    elif side == "head":
        degraded[: box.top + rows] = 0
    elif side == "left":
        degraded[:, : box.left + columns] = 0
    else:
        degraded[:, box.right - columns :] = 0
    return degraded


Kind = Callable[[Mask, Box, float, np.random.Generator], Mask]

DEGRADATIONS: Mapping[str, Kind] = {
    kind.__name__: kind
    for kind in (
        *(boundary_noise, holes, missing_limb, swollen_limb, shadow),
        *(horizontal_occluder, vertical_occluder, low_resolution, frame_cut, bag, coat),
    )
}

SEGMENTATION_FAULTS = (
    "boundary_noise",
    "holes",
    "missing_limb",
    "swollen_limb",
    "shadow",
    "horizontal_occluder",
    "vertical_occluder",
    "low_resolution",
    "frame_cut",
)
"""What segmenters and cameras do to masks, without what a person wears or carries."""


def _limb(mask: Mask, box: Box, rng: np.random.Generator) -> tuple[NDArray[np.bool_], Array32]:
    """Draw one of the thin parts of a mask, and measure how far each pixel is from the trunk.

    The trunk is what morphological opening leaves. In a mask without thin parts, the part that is
    farthest from its centre counts as one.
    """
    size = 2 * (box.height // 14) + 1
    disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
    trunk = np.asarray(cv2.morphologyEx(mask, cv2.MORPH_OPEN, disc, borderValue=0), np.uint8)
    count, labels, stats, _ = cv2.connectedComponentsWithStats(mask & ~trunk, connectivity=8)
    thin = [k for k in range(1, count) if stats[k, cv2.CC_STAT_AREA] > 0.015 * mask.sum()]
    if thin and trunk.any():
        reach = np.asarray(cv2.distanceTransform(1 - trunk, cv2.DIST_L2, 3), np.float32)
        return labels == thin[rng.integers(len(thin))], reach
    y, x = np.argwhere(mask).mean(axis=0)
    rows, columns = np.indices(mask.shape)
    away = np.hypot(rows - y, columns - x).astype(np.float32)
    limb = (mask > 0) & (away >= np.quantile(away[mask > 0], 0.85))
    return limb, np.maximum(away - away[limb].min(), 1e-3)
