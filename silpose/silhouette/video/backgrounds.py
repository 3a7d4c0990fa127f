"""Backgrounds: what a scene looks like without the person, and which pixels differ from it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Protocol

import cv2
import numpy as np

from silpose.core.types import Array32, Mask
from silpose.silhouette.video.frame import Picture
from silpose.silhouette.video.light import Light, lit
from silpose.silhouette.video.shadow import shadow

KINDS = ("median", "mog2", "knn", "selfie")
"""Ways to tell a person from the background, which may also be a picture of the empty scene."""

ADAPTIVE = ("mog2", "knn")
"""Those that go on learning."""

_NOISE = 5.0  # standard deviations of the noise that are no difference
_TO_SIGMA = 1.4826  # from the median of absolute differences
_KNN_DISTANCE, _MOG2_DISTANCE = 400.0, 16.0  # OpenCV's own squared distances, at threshold 20
_OWN_THRESHOLD = 20.0
_MOSTLY = 0.6  # share of the time that what is seen is background: a person passes by


@dataclass(frozen=True)
class Shadows:
    """Which pixels are shadows: darkest brightness, and greatest distance in chroma."""

    darkest: float
    chroma: float


@dataclass(frozen=True)
class Differing:
    """Pixels that differ from the background.

    Attributes
    ----------
    weak, strong : ndarray of 0 and 1, shape (H, W)
        Those that differ, and those of them that do beyond doubt.
    switched : bool
        Whether a light was switched since the picture before.
    """

    weak: Mask
    strong: Mask
    switched: bool


class Background(Protocol):
    """Compares pictures with a background."""

    def step(self, picture: Picture) -> Differing:
        """Compare the next picture (H, W, 3)."""


class FixedBackground:
    """A background that is one picture, brightened and darkened as the light is.

    Parameters
    ----------
    background : ndarray of uint8, shape (H, W, 3)
    threshold : float
        Grey levels by which the foreground differs at least, in one colour.
    shadows : Shadows or None
        None counts shadows as foreground.
    noise : ndarray of uint8, shape (H, W), or None, default=None
        Median absolute deviation of each pixel, where it is known.
    """

    def __init__(
        self,
        background: Picture,
        threshold: float,
        shadows: Shadows | None,
        noise: Mask | None = None,
    ) -> None:
        self.background = background
        self.threshold = threshold
        self.shadows = shadows
        self.light = Light(background)
        self._gain: Array32 | None = None
        self._lit = background
        still = np.zeros(background.shape[:2], np.uint8) if noise is None else noise
        levels = np.clip(_NOISE * _TO_SIGMA * still.astype(np.float32), threshold, 255)
        self._least = levels.astype(np.uint8)

    def step(self, picture: Picture) -> Differing:
        """Compare the next picture (H, W, 3)."""
        gain, switched = self.light.step(picture)
        if gain is not self._gain:
            self._gain, self._lit = gain, lit(self.background, gain)
        background = self._lit
        difference = _largest(np.asarray(cv2.absdiff(picture, background)))
        sigma = _TO_SIGMA * float(np.median(difference[::4, ::4]))
        least = np.maximum(self._least, np.uint8(min(_NOISE * sigma, 255)))
        weak = (difference > least).view(np.uint8)
        strong = (difference > cv2.add(least, least)).view(np.uint8)  # twice, up to 255
        if self.shadows is not None:
            found = shadow(picture, background, weak, self.shadows.darkest, self.shadows.chroma)
            lit_up = 1 - found
            weak, strong = weak & lit_up, strong & lit_up
        return Differing(weak, strong, switched)


class AdaptiveBackground:
    """OpenCV's mixture of Gaussians (MOG2) or nearest neighbours (KNN), with its shadow rule.

    Parameters
    ----------
    kind : {"mog2", "knn"}
    threshold : float
        As of `FixedBackground`; OpenCV's own are scaled by it.
    shadows : Shadows or None
        The darkest brightness is used.
    history : int
        Frames from which the background is learnt.
    first : iterable of ndarray of uint8, each (H, W, 3)
        Pictures from which it is learnt beforehand.
    """

    def __init__(
        self,
        kind: str,
        threshold: float,
        shadows: Shadows | None,
        history: int,
        first: Iterable[Picture] = (),
    ) -> None:
        scale = (threshold / _OWN_THRESHOLD) ** 2
        self._model: cv2.BackgroundSubtractorMOG2 | cv2.BackgroundSubtractorKNN
        if kind == "mog2":
            self._model = cv2.createBackgroundSubtractorMOG2(
                history, _MOG2_DISTANCE * scale, shadows is not None
            )
            self._model.setBackgroundRatio(_MOSTLY)
        else:
            self._model = cv2.createBackgroundSubtractorKNN(
                history, _KNN_DISTANCE * scale, shadows is not None
            )
            self._model.setkNNSamples(round(_MOSTLY * self._model.getNSamples()))
        if shadows is not None:
            self._model.setShadowThreshold(shadows.darkest)
        self._rate = 1 / history
        self.light: Light | None = None
        self._gain: Array32 | None = None
        self._even: Array32 | None = None
        self._seen = 0
        for picture in first:
            self.light = self.light or Light(picture)
            self._learn(picture)

    def step(self, picture: Picture) -> Differing:
        """Compare the next picture (H, W, 3), and learn from it."""
        self.light = self.light or Light(picture)
        gain, switched = self.light.step(picture)
        if gain is not self._gain:
            self._gain, self._even = gain, None if gain is None else np.float32(1) / gain
        even = lit(picture, self._even)
        found = self._learn(even)
        mask = (found > 200).view(np.uint8)  # shadows are 127
        return Differing(mask, mask, switched)

    def _learn(self, picture: Picture) -> Mask:
        self._seen += 1
        rate = max(self._rate, 1 / self._seen)
        return np.asarray(self._model.apply(picture, learningRate=rate), np.uint8)


def _largest(colours: Picture) -> Mask:
    """Take the largest of three colours in each pixel."""
    one, two, three = cv2.split(colours)
    return np.asarray(cv2.max(cv2.max(one, two), three), np.uint8)
