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
_LOST, _WANTED = 60.0, 30.0  # grey levels of noise that hide a person, and that are left by blur
_WIDEST = 0.008  # of that blur, as a share of the picture's longer side
_BLUR = 3.5  # by which a blur of one pixel divides white noise
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
        self._least = self._levels(still)
        usual = np.full_like(still, np.median(still))
        self._flicker = self._levels(np.asarray(cv2.subtract(still, usual), np.uint8))

    def step(self, picture: Picture) -> Differing:
        """Compare the next picture (H, W, 3)."""
        gain, switched = self.light.step(picture)
        if gain is not self._gain:
            self._gain, self._lit = gain, lit(self.background, gain)
        background, usual = self._lit, self._least
        difference, noise = _difference(picture, background)
        if noise > _LOST:
            picture, background = (_blurred(own, noise) for own in (picture, background))
            difference, noise = _difference(picture, background)
            usual = self._flicker
        least = np.maximum(usual, np.uint8(min(noise, 255)))
        weak = (difference > least).view(np.uint8)
        strong = (difference > cv2.add(least, least)).view(np.uint8)  # twice, up to 255
        if self.shadows is not None:
            found = shadow(picture, background, weak, self.shadows.darkest, self.shadows.chroma)
            lit_up = 1 - found
            weak, strong = weak & lit_up, strong & lit_up
        return Differing(weak, strong, switched)

    def _levels(self, still: Mask) -> Mask:
        """Differences that are no noise, of pixels (H, W) of a median absolute deviation."""
        levels = np.clip(_NOISE * _TO_SIGMA * still.astype(np.float32), self.threshold, 255)
        return levels.astype(np.uint8)


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


def _difference(picture: Picture, background: Picture) -> tuple[Mask, float]:
    """How much pixels differ, and up to where that is noise."""
    difference = _largest(np.asarray(cv2.absdiff(picture, background)))
    return difference, _NOISE * _TO_SIGMA * float(np.median(difference[::4, ::4]))


def _blurred(picture: Picture, noise: float) -> Picture:
    """Blur a picture as much as its noise asks for."""
    width = min(noise / _WANTED / _BLUR, _WIDEST * max(picture.shape[:2]))
    return np.asarray(cv2.GaussianBlur(picture, (0, 0), width), np.uint8)


def _largest(colours: Picture) -> Mask:
    """Take the largest of three colours in each pixel."""
    one, two, three = cv2.split(colours)
    return np.asarray(cv2.max(cv2.max(one, two), three), np.uint8)
