"""`MaskReader`: masks of a live source, frame by frame."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Mask
from silpose.silhouette.masks.arrays import picture_of_item
from silpose.silhouette.masks.decision import decide
from silpose.silhouette.masks.encoding import Encoding
from silpose.silhouette.masks.mask_source import MaskSource
from silpose.silhouette.masks.picture import Picture

_DECIDE_AT = (1, 2, 4, 8, 16, 32)
"""Pictures that show something, after each of which the encoding is decided anew."""


class MaskReader:
    """Reads frames as `read_masks` does, as far as the frames until now tell.

    What the pixels mean is decided on the first frames, and again when a frame is brighter than
    all of those. Nothing is learnt from a frame that is refused: the next one may be right again.

    Parameters
    ----------
    options : MaskSource, optional
        What pixels do not tell; its source is not used.
    source : str, default="the stream"
        What the source is called in messages.
    """

    def __init__(self, options: MaskSource | None = None, source: str = "the stream") -> None:
        self.options = options or MaskSource()
        self.source = source
        self.encoding: Encoding | None = None
        self._frames = 0
        self._shown: list[Picture] = []
        self._brightest = -np.inf
        self._said: set[str] = set()

    def step(self, frame: Any) -> Mask:
        """Read the next frame.

        Parameters
        ----------
        frame : array-like, shape (H, W) or (H, W, C), or image of Pillow

        Returns
        -------
        mask : ndarray of 0 and 1, shape (H, W)

        Raises
        ------
        InputError
            If the frame cannot be read, or shows several people with labels of their own.

        Warns
        -----
        UserWarning
            Once, if there is a doubt about the source.
        """
        pictures = picture_of_item(frame, self._frames, self.source)
        if len(pictures) != 1:
            raise InputError(
                f"frame {self._frames} of {self.source} holds {len(pictures)} pictures: "
                "give one at a time"
            )
        self._frames += 1
        before = self.encoding, list(self._shown), self._brightest
        try:
            self._learn(pictures[0])
        except InputError:
            self.encoding, self._shown, self._brightest = before
            raise
        assert self.encoding is not None
        return self.encoding.apply(pictures[0])

    def _learn(self, picture: Picture) -> None:
        low, high = picture.pixels.min(), picture.pixels.max()
        if low == high and self.encoding is not None:
            return
        brighter = float(high) > self._brightest
        settled = len(self._shown) >= _DECIDE_AT[-1]
        if settled and not brighter:
            return
        if low != high:
            if settled:
                self._shown.pop(0)
            self._shown.append(picture)
            self._brightest = max(self._brightest, float(high))
        if brighter or len(self._shown) in _DECIDE_AT or self.encoding is None:
            self._decide(self._shown or [picture])

    def _decide(self, pictures: list[Picture]) -> None:
        self.encoding = decide(pictures, self.options, self.source)
        for doubt in self.encoding.doubts:
            if doubt not in self._said:
                self._said.add(doubt)
                warnings.warn(doubt, UserWarning, stacklevel=4)
