"""Lines and titles in pictures that are drawn without a viewer."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from silpose.core.types import Array
from silpose.recording import palette

PALE = 190, 192, 198
"""Colour of titles and silhouettes, as in the viewer."""

Picture = NDArray[np.uint8]
"""Red, green and blue, shape (H, W, 3)."""


def with_title(picture: Picture, title: str) -> Picture:
    """Write a panel's title into its corner."""
    image, size = Image.fromarray(picture), len(picture)
    font = ImageFont.load_default(size=max(11.0, 0.05 * size))
    ImageDraw.Draw(image).text((0.04 * size, 0.03 * size), title, fill=PALE, font=font)
    return np.asarray(image)


def draw_line(canvas: Picture, ends: Array, colour: palette.Colour, radius: float) -> None:
    """Draw a line between two points (2, 2) into a square panel of width 1; none if not finite."""
    if np.isfinite(ends).all():
        one, other = (tuple(end) for end in np.rint(len(canvas) * ends).astype(int).tolist())
        thickness = max(1, round(2 * radius * len(canvas)))
        cv2.line(canvas, one, other, colour, thickness, cv2.LINE_AA)
