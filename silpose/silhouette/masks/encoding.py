"""`Encoding`: how the pixels of a source become masks, the same for all its pictures."""

from __future__ import annotations

from dataclasses import dataclass

from silpose.core.errors import InputError
from silpose.core.types import Mask
from silpose.silhouette.masks.labels import Labels
from silpose.silhouette.masks.picture import Picture
from silpose.silhouette.masks.planes import Plane
from silpose.silhouette.masks.thresholds import Threshold


class NoMasksError(InputError):
    """Pictures that are no masks."""


@dataclass(frozen=True)
class Encoding:
    """How the pixels of a source become masks.

    Attributes
    ----------
    plane : Plane
    rule : Threshold or Labels
    words : str
    doubts : tuple of str
        A sentence each.
    """

    plane: Plane
    rule: Threshold | Labels
    words: str
    doubts: tuple[str, ...] = ()

    def apply(self, picture: Picture) -> Mask:
        """Return the mask of a picture, of 0 and 1, shape (H, W)."""
        values = self.plane.of(picture)
        if values.ndim != 2:
            raise NoMasksError(
                f"'{picture.name}' is in colours, and those before were masks: segment it as those"
            )
        return self.rule.apply(values)
