"""The background that is chosen, learnt from its source."""

from __future__ import annotations

import warnings
from pathlib import Path

import cv2
import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Mask
from silpose.silhouette.video.backgrounds import (
    ADAPTIVE,
    AdaptiveBackground,
    Background,
    FixedBackground,
    Shadows,
)
from silpose.silhouette.video.clock import USUAL
from silpose.silhouette.video.folder_frames import read_picture
from silpose.silhouette.video.frame import Picture, alike
from silpose.silhouette.video.light import Light, lit
from silpose.silhouette.video.median import median_picture
from silpose.silhouette.video.open_source import Frames

_FEWEST = 3  # frames of which a median is something else than one of them
_SHORT = 1.0  # seconds in which a person may stay at one place for most of the time
_SWITCHED = 0.15  # mean log of a gain from which a light was switched
_GREY = 6  # levels by which the colours of a grey picture differ at most, compressed


def sample_of(frames: Frames, samples: int) -> list[Picture]:
    """Decode so many pictures evenly over a source, of one size; none of a live one."""
    pictures = [frame.picture for frame in frames.sample(samples)]
    return [picture for picture in pictures if picture.shape == pictures[0].shape]


def learn_background(
    kind: str,
    frames: Frames,
    pictures: list[Picture],
    history: int,
    threshold: float,
    shadows: Shadows | None,
) -> Background:
    """Learn a background from a source, or read it.

    Parameters
    ----------
    kind : str
        median, one of `ADAPTIVE`, or the path of a picture of the empty scene.
    frames : Frames
    pictures : list of ndarray of uint8, each (H, W, 3)
        A sample of them, of `sample_of`, from which it is learnt beforehand.
    history : int
        Frames over which an adaptive one learns and forgets.
    threshold : float
        Grey levels by which the foreground differs at least.
    shadows : Shadows or None
        None counts shadows as foreground.

    Raises
    ------
    InputError
        If there are too few frames for a median, or the picture is none of the same camera.

    Warns
    -----
    UserWarning
        If the pictures are grey, so that there is no shadow rule, or too short for a median to be
        the scene.
    """
    if kind in ADAPTIVE:
        return AdaptiveBackground(kind, threshold, shadows, history, pictures)
    noise: Mask | None = None
    if kind == "median":
        if len(pictures) < _FEWEST:
            raise InputError(
                f"{frames.name} has fewer than {_FEWEST} frames, too few for a median: give a "
                "picture of the empty scene, silhouette.video.background=FILE (in Python "
                "background='FILE')"
            )
        seconds = frames.announced / (frames.frames_per_second or USUAL)
        if seconds < _SHORT:
            warnings.warn(
                f"{frames.name} lasts {seconds:.1f} s, in which a person may hardly move and be "
                "taken for the scene: give a picture of the empty scene, "
                "silhouette.video.background=FILE (in Python background='FILE')",
                stacklevel=4,
            )
        picture, noise = median_picture(_in_one_light(pictures))
    else:
        picture = _empty_scene(Path(kind), frames)
    if shadows is not None and np.ptp(picture, axis=-1).max() <= _GREY:
        shadows = None  # all that is darker would be a shadow
        warnings.warn(
            f"the background of {frames.name} is grey, so shadows are not told from the person "
            "by their colour, and are not left out",
            stacklevel=4,
        )
    return FixedBackground(picture, threshold, shadows, noise)


def _in_one_light(pictures: list[Picture]) -> list[Picture]:
    """Brighten and darken pictures to the light of the middle one, if a light was switched.

    Otherwise how light drifts is left to the measured noise.
    """
    light = Light(pictures[len(pictures) // 2])
    gains = [light.step(picture)[0] for picture in pictures]
    means = [0.0 if gain is None else float(np.log(gain).mean()) for gain in gains]
    if max(np.abs(means)) < _SWITCHED:
        return pictures
    return [
        picture if gain is None else lit(picture, np.float32(1) / gain)
        for picture, gain in zip(pictures, gains, strict=True)
    ]


def _empty_scene(file: Path, frames: Frames) -> Picture:
    """Read the picture of the empty scene, in the size of the source's."""
    height, width = frames.size
    picture = read_picture(file, max(height, width))
    if not alike(picture.shape, (height, width)):
        raise InputError(
            f"the background '{file}' is {picture.shape[1]}x{picture.shape[0]} and pictures of "
            f"{frames.name} are {width}x{height}: give a picture of the same camera"
        )
    return np.asarray(cv2.resize(picture, (width, height), interpolation=cv2.INTER_AREA), np.uint8)
