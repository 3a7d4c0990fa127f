"""Masks of what is no person, at about a person's place and size, to test and to learn doubt on."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import cv2
import numpy as np

from silpose.core.types import Mask

_Corner = tuple[int, int]
Shape = Callable[[Mask, float, tuple[float, float], np.random.Generator], None]


def foreign_shape(
    height: int, width: int, tall: float, rng: np.random.Generator, kind: str | None = None
) -> Mask:
    """Draw one of `FOREIGN`.

    Parameters
    ----------
    height, width : int
        Of the mask, pixels.
    tall : float
        Height of a person there, pixels; shapes are half as tall to half as tall again.
    rng : numpy.random.Generator
    kind : str, optional
        Any by default.

    Returns
    -------
    mask : ndarray of 0 and 1, shape (H, W)
        Never blank.
    """
    mask = np.zeros((height, width), np.uint8)
    place = tuple(rng.normal((width / 2, height / 2), 0.05 * tall))
    kinds = list(FOREIGN)
    draw = FOREIGN[kind or kinds[int(rng.integers(len(kinds)))]]
    draw(mask, tall * rng.uniform(0.5, 1.5), (float(place[0]), float(place[1])), rng)
    if not mask.any():
        mask[height // 2, width // 2] = 1
    return mask


def _disc(mask: Mask, tall: float, place: tuple[float, float], rng: np.random.Generator) -> None:
    axes = max(1, round(tall / 2 * rng.uniform(0.3, 1.0))), max(1, round(tall / 2))
    cv2.ellipse(mask, _at(place), axes, rng.uniform(-30, 30), 0, 360, 1, -1)


def _box(mask: Mask, tall: float, place: tuple[float, float], rng: np.random.Generator) -> None:
    size = (tall * rng.uniform(0.2, 1.0), tall)
    corners = cv2.boxPoints((place, size, rng.uniform(-20, 20)))
    cv2.fillConvexPoly(mask, corners.round().astype(np.int32), 1)


def _chair(mask: Mask, tall: float, place: tuple[float, float], rng: np.random.Generator) -> None:
    """Fill a seat with a back and legs."""
    x, y = place
    half, leg = tall * rng.uniform(0.2, 0.4), tall * rng.uniform(0.03, 0.07)
    thick = tall * rng.uniform(0.04, 0.12)
    side = rng.choice([-1, 1])
    _fill(mask, x - half, x + half, y, y + thick)
    _fill(mask, x + side * half, x + side * (half - leg), y - tall / 2, y)
    for column in (-half, half - leg):
        _fill(mask, x + column, x + column + leg, y, y + tall / 2)


def _tree(mask: Mask, tall: float, place: tuple[float, float], rng: np.random.Generator) -> None:
    """Fill a crown on a trunk, or a sign on a post."""
    x, y = place
    trunk, crown = tall * rng.uniform(0.02, 0.08), tall * rng.uniform(0.12, 0.3)
    _fill(mask, x - trunk, x + trunk, y - tall / 2 + crown, y + tall / 2)
    cv2.circle(mask, _at((x, y - tall / 2 + crown)), max(1, round(crown)), 1, -1)


def _dog(mask: Mask, tall: float, place: tuple[float, float], rng: np.random.Generator) -> None:
    """Fill a long trunk on four legs, with a head."""
    x, y = place
    side, leg = rng.choice([-1, 1]), tall * rng.uniform(0.04, 0.07)
    cv2.ellipse(mask, _at(place), _at((0.4 * tall, 0.14 * tall)), 0, 0, 360, 1, -1)
    for column in (-0.34, -0.22, 0.22, 0.34):
        _fill(mask, x + column * tall, x + column * tall + leg, y, y + 0.4 * tall)
    head = (x + side * 0.42 * tall, y - 0.18 * tall)
    cv2.circle(mask, _at(head), max(1, round(0.12 * tall)), 1, -1)


def _polygon(mask: Mask, tall: float, place: tuple[float, float], rng: np.random.Generator) -> None:
    """Fill a star-shaped polygon with a ragged outline."""
    turn = np.sort(rng.uniform(0, 2 * np.pi, int(rng.integers(4, 14))))
    radius = tall / 2 * rng.uniform(0.3, 1.0, len(turn))
    corners = np.stack([radius * np.cos(turn), radius * np.sin(turn)], axis=1) + place
    cv2.fillPoly(mask, [corners.round().astype(np.int32)], 1)


def _blobs(mask: Mask, tall: float, place: tuple[float, float], rng: np.random.Generator) -> None:
    """Threshold smooth noise, as a background that is not subtracted."""
    noise = cv2.GaussianBlur(rng.standard_normal(mask.shape), (0, 0), max(1.0, tall / 20))
    mask[noise > np.quantile(noise, rng.uniform(0.6, 0.9))] = 1


def _full(mask: Mask, tall: float, place: tuple[float, float], rng: np.random.Generator) -> None:
    """Fill the frame, but for a margin perhaps."""
    margin = int(rng.integers(0, 4)) * mask.shape[0] // 40
    mask[margin : mask.shape[0] - margin, margin : mask.shape[1] - margin] = 1


def _at(place: tuple[float, float]) -> _Corner:
    return round(place[0]), round(place[1])


def _fill(mask: Mask, left: float, right: float, top: float, bottom: float) -> None:
    one, other = sorted((left, right))
    cv2.rectangle(mask, _at((one, top)), _at((other, bottom)), 1, -1)


FOREIGN: Mapping[str, Shape] = {
    "disc": _disc, "box": _box, "chair": _chair, "tree": _tree, "dog": _dog, "polygon": _polygon,
    "blobs": _blobs, "full": _full,
}  # fmt: skip
"""Kinds of shapes that are no person's."""
