"""`GivenMasks`: pictures that are masks already, of any other segmenter."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from silpose.core.types import Mask
from silpose.silhouette.video.backgrounds import Differing
from silpose.silhouette.video.frame import Picture

_END = 40  # grey levels from black and from white that are either, compressed
_MOST = 0.98  # share of the pixels of a mask that are black or white; edges are between
_GREY = 12  # levels by which the colours of a compressed mask differ at most
_LEAST = 0.0005  # share of all pixels that are of the person, and of the background


class GivenMasks:
    """Takes pictures as the masks that they are.

    Parameters
    ----------
    middle : float
        Grey level between the person's and the background's.
    bright : bool
        Whether the person is the brighter one.
    """

    def __init__(self, middle: float, bright: bool) -> None:
        self.middle = middle
        self.bright = bright

    def step(self, picture: Picture) -> Differing:
        """Take the next picture (H, W, 3)."""
        mask: Mask = ((picture[:, :, 1] > self.middle) == self.bright).view(np.uint8)
        return Differing(mask, mask, switched=False)


def given_masks(pictures: Sequence[Picture]) -> GivenMasks | None:
    """Tell masks from pictures of a scene.

    Parameters
    ----------
    pictures : sequence of ndarray of uint8, each (H, W, 3)
        A sample of a film or folder.

    Returns
    -------
    masks : GivenMasks or None
        None unless every picture is grey and of two levels, or nearly all black and white. What
        most of the pictures' edges show is the background.
    """
    if not pictures or any(_coloured(picture) for picture in pictures):
        return None
    planes = [picture[:, :, 1] for picture in pictures]
    counts = np.sum([np.bincount(plane.ravel(), minlength=256) for plane in planes], axis=0)
    levels = np.flatnonzero(counts)
    if len(levels) == 2:
        middle = float(levels.mean())
    elif all(_black_and_white(plane) for plane in planes):
        middle = 127.5
    else:
        return None
    above = counts[np.arange(256) > middle].sum() / counts.sum()
    if not _LEAST < above < 1 - _LEAST:
        return None
    edges = [np.concatenate([p[0], p[-1], p[:, 0], p[:, -1]]) > middle for p in planes]
    return GivenMasks(middle, bright=bool(np.concatenate(edges).mean() < 0.5))


def _coloured(picture: Picture) -> bool:
    return bool((np.ptp(picture, axis=-1) > _GREY).mean() > 1 - _MOST)


def _black_and_white(plane: Mask) -> bool:
    return bool(((plane <= _END) | (plane >= 255 - _END)).mean() >= _MOST)
