"""The scale at which contours are compared, so that a pixel means the same for masks of any size.

All lengths in pixels in this package are of an image in which a person is about as tall as with the
default camera. Larger masks are reduced to that; of smaller ones the contour is enlarged.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import cv2
import numpy as np

from silpose.core.types import Array, Mask
from silpose.fitting.contour import Contour, contour_of
from silpose.fitting.geometry import Geometry
from silpose.fitting.overlap import overlap, silhouette_of
from silpose.fitting.parameters import ANGLES, SHIFT_X, SHIFT_Y
from silpose.fitting.view import View
from silpose.silhouette import Camera

_TALL = 193.0  # pixels of a person
_PERSON = 1.7  # metres
_STEPS = 2  # of factors, for each doubling: a person is a fifth taller or smaller at most
_OTHER = 1.5  # factor of a person's height from which the scale changes
_COVERED = 25  # of 255: a pixel that is hardly covered counts, as where bodies are rendered
_MOST = 24.0  # factor by which contours are enlarged


class WorkingSize(NamedTuple):
    """Size of masks and scale of contours that are compared.

    Attributes
    ----------
    height, width : int
        Of masks, which are reduced at most.
    reduction : float
        Of masks, 1 at most.
    enlargement : float
        Of contours relative to these masks, 1 at least.
    """

    height: int
    width: int
    reduction: float
    enlargement: float

    @classmethod
    def for_person(cls, camera: Camera, tall: float) -> WorkingSize:
        """Choose the size by how tall a person is in the camera's image, pixels."""
        wanted = 2 ** (round(_STEPS * np.log2(_TALL / max(tall, 1.0))) / _STEPS)
        height = max(1, round(camera.height * min(1.0, wanted)))
        reduction = height / camera.height
        width = max(1, round(camera.width * reduction))
        return cls(height, width, reduction, float(np.clip(wanted, 1.0, _MOST)))

    def followed(self, camera: Camera, mask: Mask) -> WorkingSize:
        """Size for the next mask: another if a person is much taller or smaller there."""
        tall = seen_height([mask])
        if tall is None:
            return self
        wanted = self.for_person(camera, tall)
        return self if 1 / _OTHER < wanted.factor / self.factor < _OTHER else wanted

    @property
    def factor(self) -> float:
        """By which a camera's pixels differ from those of contours."""
        return self.reduction * self.enlargement

    def mask(self, mask: Mask) -> Mask:
        """Reduce a mask, of any values, to one of 0 and 1."""
        binary = (np.asarray(mask) != 0).astype(np.uint8)
        if self.reduction == 1:
            return binary
        size = self.width, self.height
        soft = np.asarray(cv2.resize(255 * binary, size, interpolation=cv2.INTER_AREA))
        return (soft > _COVERED).astype(np.uint8)

    def contour(self, mask: Mask) -> Contour:
        """Trace the contour of a mask of this size, at the contours' scale."""
        return contour_of(mask, self.enlargement)

    def view(self, view: View) -> View:
        """See contours as the camera sees its image."""
        return _scaled(view, self.factor)

    def overlap(
        self, mask: Mask, parameters: Array, root: Array, geometry: Geometry, view: View
    ) -> float:
        """Compare a mask of this size with the body that parameters (P,) at this scale describe.

        `view` is the camera's own.
        """
        own = parameters.copy()
        if len(own) > ANGLES:
            own[[SHIFT_X, SHIFT_Y]] /= self.enlargement
        seen = _scaled(view, self.reduction)
        return overlap(silhouette_of(own, root, geometry, seen, self.height, self.width), mask)


def _scaled(view: View, factor: float) -> View:
    return view._replace(
        focal=factor * view.focal,
        centre_x=factor * (view.centre_x + 0.5) - 0.5,
        centre_y=factor * (view.centre_y + 0.5) - 0.5,
        shift_x=factor * view.shift_x,
        shift_y=factor * view.shift_y,
    )


def expected_height(camera: Camera) -> float:
    """Height of a person in a camera's image, pixels."""
    return camera.focal_pixels * _PERSON / camera.distance


def seen_height(masks: Sequence[Mask]) -> float | None:
    """Median height of what masks show, pixels; None if all are blank."""
    rows = [np.flatnonzero(np.asarray(mask).any(axis=1)) for mask in masks]
    heights = [own[-1] - own[0] + 1 for own in rows if len(own)]
    return float(np.median(heights)) if heights else None
