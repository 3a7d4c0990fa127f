"""Masks with their descriptions, some of them blank."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Array, Indices
from silpose.descriptor import Description


@dataclass(frozen=True)
class DescribedMasks:
    """Masks, which of them have a foreground, and the descriptions of these.

    Attributes
    ----------
    masks : list of ndarray, each (H, W)
    visible : ndarray of int, shape (V,)
        Frames with a foreground.
    descriptions : list of Description
        Of these.
    """

    masks: list[NDArray[Any]]
    visible: Indices
    descriptions: list[Description]

    @property
    def z(self) -> Array:
        """Descriptors, shape (F, d); NaN for a blank mask."""
        return self.spread(np.stack([description.z for description in self.descriptions]))

    def spread(self, rows: Array) -> Array:
        """Put a row of each visible mask (V, d) at its frame (F, d), and NaN elsewhere."""
        spread = np.full((len(self.masks), rows.shape[1]), np.nan)
        spread[self.visible] = rows
        return spread
