"""Masks to calibrate with that are not as in training: damaged, cut, stretched, of something else.

Each kind is drawn at a random strength, and most of them beyond what an estimate survives: whether
it does is what confidence learns to tell.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import cv2
import numpy as np

from silpose.core.skeleton import ANGLES
from silpose.core.types import Array, Mask
from silpose.silhouette import DEGRADATIONS, degrade, foreign_shape
from silpose.silhouette.degradations import Box

NOBODY = ("foreign",)
"""Kinds that show no person at all, so that no pose is right."""

_FAR_BENT = [
    k
    for k, name in enumerate(ANGLES)
    if any(f"_{joint}_" in name for joint in ("shoulder", "elbow", "hip", "knee"))
]
_MARGIN = 8  # pixels around what is warped


def odd_mask(kind: str, mask: Mask, other: Mask, rng: np.random.Generator) -> Mask:
    """Make an odd mask from that of a person.

    Parameters
    ----------
    kind : str
        One of `ODD`.
    mask, other : ndarray of 0 and 1, shape (H, W)
        Of a person, and of the same or another one in another pose.
    rng : numpy.random.Generator

    Returns
    -------
    odd : ndarray of 0 and 1, shape (H', W')
    """
    return ODD[kind](mask, other, rng)


def _degraded(kind: str) -> Callable[[Mask, Mask, np.random.Generator], Mask]:
    return lambda mask, other, rng: degrade(mask, kind, float(rng.uniform(0.1, 1)), rng)


def _cut(mask: Mask, other: Mask, rng: np.random.Generator) -> Mask:
    """Crop the image within the person."""
    box, share = Box.of(mask), rng.uniform(0.05, 0.6)
    side = rng.choice(["feet", "head", "left", "right"], p=[0.5, 0.2, 0.15, 0.15])
    if side == "feet":
        return mask[: box.bottom - round(share * box.height)]
    if side == "head":
        return mask[box.top + round(share * box.height) :]
    if side == "left":
        return mask[:, box.left + round(share * box.width) :]
    return mask[:, : box.right - round(share * box.width)]


def _stretched(mask: Mask, other: Mask, rng: np.random.Generator) -> Mask:
    """Change the proportions by a factor from a third to 3."""
    factor = float(np.exp(rng.uniform(-1.1, 1.1)))
    tall = 1 / np.sqrt(factor)
    part = _part(mask)
    size = max(2, round(part.shape[1] * factor * tall)), max(2, round(part.shape[0] * tall))
    return _framed((cv2.resize(part * 255, size, interpolation=cv2.INTER_AREA) > 127).astype("u1"))


def _turned(mask: Mask, other: Mask, rng: np.random.Generator) -> Mask:
    """Turn the image, at times upside down."""
    quarter = int(rng.integers(1, 4))
    if rng.random() < 0.5:
        return np.ascontiguousarray(np.rot90(mask, quarter))
    part = _part(mask)
    side = 2 * max(part.shape)
    angle = float(rng.choice([-1, 1]) * rng.uniform(8, 60))
    turn = cv2.getRotationMatrix2D((part.shape[1] / 2, part.shape[0] / 2), angle, 1.0)
    turn[:, 2] += [(side - part.shape[1]) / 2, (side - part.shape[0]) / 2]
    return _framed(np.asarray(cv2.warpAffine(part, turn, (side, side)), np.uint8))


def _upside_down(mask: Mask, other: Mask, rng: np.random.Generator) -> Mask:
    """Flip the image, as that of a camera that hangs from the ceiling, or of arrays from below."""
    return mask[::-1].copy() if rng.random() < 0.5 else mask[::-1, ::-1].copy()


def _merged(mask: Mask, other: Mask, rng: np.random.Generator) -> Mask:
    """Put another person partly in front, so that the two are one component."""
    box = Box.of(mask)
    shift = float(rng.choice([-1, 1]) * rng.uniform(0.1, 0.5)) * box.height
    drop = float(rng.uniform(-0.1, 0.1)) * box.height
    sides = 0, 0, box.height // 2, box.height // 2
    wide = cv2.copyMakeBorder(mask, *sides, cv2.BORDER_CONSTANT)
    moving = cv2.copyMakeBorder(other, *sides, cv2.BORDER_CONSTANT)
    while True:
        move = np.array([[1.0, 0, round(shift)], [0, 1, round(drop)]])
        both = wide | np.asarray(cv2.warpAffine(moving, move, wide.shape[::-1]), np.uint8)
        if abs(shift) < 1 or cv2.connectedComponents(both)[0] == 2:
            return np.asarray(both, np.uint8)
        shift, drop = 0.85 * shift, 0.85 * drop


def _thick(mask: Mask, other: Mask, rng: np.random.Generator) -> Mask:
    """Grow the outline on all sides, as a coat or a low threshold does."""
    size = 2 * round(rng.uniform(0.005, 0.06) * Box.of(mask).height) + 1
    return np.asarray(cv2.dilate(mask, _disc(size)), np.uint8)


def _thin(mask: Mask, other: Mask, rng: np.random.Generator) -> Mask:
    """Shrink the outline on all sides, as a high threshold does."""
    size = 2 * round(rng.uniform(0.003, 0.02) * Box.of(mask).height) + 1
    thin = np.asarray(cv2.erode(mask, _disc(size)), np.uint8)
    return thin if thin.any() else mask


def _coarse(mask: Mask, other: Mask, rng: np.random.Generator) -> Mask:
    """Shrink the image until the person is 8 to 64 pixels high."""
    part = _part(mask)
    factor = float(np.exp(rng.uniform(np.log(8), np.log(64)))) / part.shape[0]
    size = max(2, round(part.shape[1] * factor)), max(2, round(part.shape[0] * factor))
    return (cv2.resize(part * 255, size, interpolation=cv2.INTER_AREA) > 127).astype(np.uint8)


def _carrying(mask: Mask, other: Mask, rng: np.random.Generator) -> Mask:
    """Add a thing that touches the person: a bag, a bicycle, a table."""
    box, odd = Box.of(mask), mask.copy()
    person = np.argwhere(mask)
    y, x = person[rng.integers(len(person))]
    size = rng.uniform(0.05, 0.4, 2) * box.height
    if rng.random() < 0.5:
        axes = int(size[0] / 2), int(size[1] / 2)
        cv2.ellipse(odd, (int(x), int(y)), axes, float(rng.uniform(0, 180)), 0, 360, 1, -1)
    else:
        corner = int(x - size[0] * rng.random()), int(y - size[1] * rng.random())
        cv2.rectangle(odd, corner, (corner[0] + int(size[0]), corner[1] + int(size[1])), 1, -1)
    return odd


def _foreign(mask: Mask, other: Mask, rng: np.random.Generator) -> Mask:
    """Draw something else of about the person's size."""
    tall = Box.of(mask).height
    return foreign_shape(2 * tall, 2 * tall, tall, rng)


def _part(mask: Mask) -> Mask:
    box = Box.of(mask)
    return mask[box.top : box.bottom, box.left : box.right]


def _framed(mask: Mask) -> Mask:
    return np.pad(mask, _MARGIN)


def _disc(size: int) -> Mask:
    return np.asarray(cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size)), np.uint8)


ODD: Mapping[str, Callable[[Mask, Mask, np.random.Generator], Mask]] = {
    **{kind: _degraded(kind) for kind in DEGRADATIONS},
    "cut": _cut, "stretched": _stretched, "turned": _turned, "upside_down": _upside_down,
    "merged": _merged, "thick": _thick, "thin": _thin, "coarse": _coarse, "carrying": _carrying,
    "foreign": _foreign,
}  # fmt: skip


def odd_poses(angles: Array, rng: np.random.Generator) -> Array:
    """Bend joints of poses as no one does who walks: some a little, in half of them a few far.

    Parameters
    ----------
    angles : ndarray, shape (F, 54)
        Degrees, the heading first.
    rng : numpy.random.Generator

    Returns
    -------
    angles : ndarray, shape (F, 54)
    """
    odd, size = angles.copy(), (len(angles), 1)
    bent = rng.random((len(angles), angles.shape[1] - 1)) < rng.uniform(0.05, 0.4, size)
    odd[:, 1:] += bent * rng.uniform(10, 50, size) * rng.standard_normal(bent.shape)
    for pose in odd[::2]:
        joints = rng.choice(_FAR_BENT, rng.integers(1, 5))
        pose[joints] += rng.choice([-1, 1], len(joints)) * rng.uniform(40, 110, len(joints))
    return odd
