"""`MaskSource`: where a user's masks are, and what pixels alone do not tell about them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from silpose.core.errors import InputError
from silpose.silhouette.blank_masks import check_blank

_OF_FILMS = ("body_height", "focal_length")


@dataclass(frozen=True)
class MaskSource:
    """Masks of one's own: where they are, and how they are read.

    Attributes
    ----------
    source : str or None, default=None
        Path of the masks: an image, a folder of images, a video, an array in a file (npy, npz),
        or run-length encoded masks (JSON of COCO or SAM).
    blank : {"error", "nan"}, default="error"
        Whether a mask without a person is an error, or gives a row of NaN.
    frames_per_second : float or None, default=None
        Frames per second; null takes the video's own.
    label : int, str, sequence of int, or None, default=None
        Which labels of a label image are the person: a number, several, or all; null where there
        is one only, or where all are parts of one body.
    person : str or None, default=None
        Who it is if there are several: largest, left, right, tracked, or a number from the left.
    inverted : bool or None, default=None
        Whether the person is darker than the background; null asks the borders of the masks.
    threshold : float or None, default=None
        Value above which a pixel is the person, in the units of the source; null finds it.
    body_height : float or None, default=None
        Height of the person in a film, metres; null takes that of the fitted body.
    focal_length : float or None, default=None
        Focal length of a film's camera, in longer sides of its pictures; null takes 0.9, as of
        phones and webcams.
    """

    source: str | None = None
    blank: str = "error"
    frames_per_second: float | None = None
    label: int | str | Sequence[int] | None = None
    person: str | None = None
    inverted: bool | None = None
    threshold: float | None = None
    body_height: float | None = None
    focal_length: float | None = None

    @property
    def reading(self) -> dict[str, Any]:
        """Parameters of how masks are read, without where they are and what films have besides."""
        return {n: v for n, v in vars(self).items() if n not in ("source", *_OF_FILMS)}

    def __post_init__(self) -> None:
        check_blank(self.blank)
        rate = self.frames_per_second
        if rate is not None and not 0 < rate < np.inf:
            raise InputError(f"silhouette.frames_per_second must be a positive number, not {rate}")
        if self.threshold is not None and not np.isfinite(self.threshold):
            raise InputError(f"silhouette.threshold must be a number, not {self.threshold}")
