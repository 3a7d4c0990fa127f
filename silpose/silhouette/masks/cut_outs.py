"""Photos of a person that were cut out, before a background of one colour."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from silpose.silhouette.masks.picture import Picture, Pixels
from silpose.silhouette.masks.planes import Plane, grey_or_colours

_BORDER = 0.6  # least share of the pictures' borders that has the one colour
_AREA = 0.2  # least share of each picture
_FLAT = 0.8  # least share of its pixels that lie among their like; the black of a photo is noisy
_COMPRESSED = 24  # of 255: differences that compression makes beside edges
_TRACES, _FEW_TRACES = 4, 0.05  # differences that only compression makes of more than a few pixels
_DEEP = 0.75  # quantile of the distances to the background beyond which pixels are surely inside
_NEAR = 0.15 * 255  # from the usual value inside, which a mask's soft edges are not
_ALIKE = 0.75  # share of the inside from which it has one value, as a mask has
_RISES = 0.5  # correlation of depth and value from which a mask is soft, and not a photo
_ENOUGH = 40  # pixels inside; smaller pictures are hardly more than edges
_LOOKED_AT = 20  # pictures
_AROUND = np.ones((3, 3), np.uint8)


def plane_of_cut_outs(pictures: Sequence[Picture], no_masks: bool = False) -> Plane | None:
    """Find what differs from a background of one colour, as in photos that were cut out.

    Parameters
    ----------
    pictures : sequence of Picture
    no_masks : bool, default=False
        Whether it is known that not all are masks; then the one colour must be exact, which no
        photo of a plain wall has.

    Returns
    -------
    plane : Plane or None
        Of 0 and 1; None if pictures show a scene, or are masks, whose inside has one value.
    """
    if any(p.palette is not None or p.alpha is not None for p in pictures):
        return None
    if any(p.pixels.dtype != np.uint8 for p in pictures):
        return None
    positions = np.unique(np.linspace(0, len(pictures) - 1, _LOOKED_AT).astype(int))
    sample = [grey_or_colours(pictures[k]) for k in positions]
    if len({pixels.ndim for pixels in sample}) > 1:
        return None
    edges = np.concatenate([edge for pixels in sample for edge in _edges(pixels)])
    found, counts = np.unique(edges.reshape(len(edges), -1), axis=0, return_counts=True)
    colour = found[int(np.argmax(counts))].astype(np.int16)
    tolerance = _tolerance([_distance(pixels, colour) for pixels in sample])
    if (_distance(edges[None], colour) <= tolerance).mean() < _BORDER:
        return None
    if no_masks and tolerance:
        return None
    if not no_masks and np.mean([_varies(p, colour, tolerance) for p in sample]) <= 0.5:
        return None
    whole = (grey_or_colours(picture) for picture in pictures)
    if not all(_is_behind(_distance(pixels, colour) <= tolerance) for pixels in whole):
        return None
    return Plane(
        f"what differs from the background's colour ({', '.join(map(str, colour))})",
        lambda p: (_distance(grey_or_colours(p), colour) > tolerance).view(np.uint8),
        cut_out=True,
    )


def _edges(pixels: Pixels) -> tuple[Pixels, ...]:
    return pixels[0], pixels[-1], pixels[:, 0], pixels[:, -1]


def _distance(pixels: Pixels, colour: Pixels) -> Pixels:
    """Largest difference of a channel, shape (H, W)."""
    own = pixels[:, :, None] if pixels.ndim == 2 else pixels
    return np.abs(own - colour).max(axis=2)


def _tolerance(distances: Sequence[Pixels]) -> int:
    """Difference up to which a pixel is behind: none, unless there are traces of compression."""
    traces = sum(int(((d > 0) & (d <= _TRACES)).sum()) for d in distances)
    others = sum(int((d > 0).sum()) for d in distances)
    return _COMPRESSED if traces > _FEW_TRACES * others else 0


def _varies(pixels: Pixels, colour: Pixels, tolerance: int) -> bool:
    """Whether what is farthest from the background has no value of its own."""
    far = _distance(pixels, colour)
    depth = cv2.distanceTransform((far > tolerance).view(np.uint8), cv2.DIST_L2, 3)
    inside = depth > 0
    if not inside.any():
        return False
    deep = depth >= np.quantile(depth[inside], _DEEP)
    values = pixels[deep].reshape(int(deep.sum()), -1).astype(float)
    near = np.abs(values - np.median(values, axis=0)).max(axis=1) < _NEAR
    if len(near) < _ENOUGH or near.mean() >= _ALIKE:
        return False
    return bool(np.corrcoef(depth[inside], far[inside])[0, 1] < _RISES)


def _is_behind(same: Pixels) -> bool:
    flat = cv2.erode(same.view(np.uint8), _AROUND)
    return bool(same.mean() >= _AREA and flat.sum() >= _FLAT * same.sum())
