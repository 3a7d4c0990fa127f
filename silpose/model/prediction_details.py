"""The intermediate results behind estimated poses."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Array, Mask
from silpose.silhouette.person import MaskFacts


@dataclass(frozen=True)
class PredictionDetails:
    """Intermediate results of a prediction for F frames.

    Attributes
    ----------
    masks : list of ndarray, each (H, W)
        Of the person alone; empty, as the points, where there are descriptors only.
    points : list of ndarray, each (P, 2)
        Edge points, pixels; none where nobody was seen.
    nearest : list of ndarray of int, each (P,)
        The codebook centre nearest to each.
    z : ndarray, shape (F, d)
        Descriptors; NaN where nobody was seen, as the following.
    activations : ndarray, shape (F, k)
        Activations of the basis functions that are kept.
    x : ndarray, shape (F, D)
        Estimated poses.
    facts : MaskFacts or None, default=None
        What was seen in each mask; None where there are descriptors only.
    names : list of str
        What the masks are called in tables.
    source : str, default=""
        What they are called together in messages.
    frames_per_second : float or None, default=None
        Rate that was given, or that the source has; None if it is not known.
    """

    masks: list[Mask]
    points: list[NDArray[np.int32]]
    nearest: list[NDArray[np.int32]]
    z: Array
    activations: Array
    x: Array
    facts: MaskFacts | None = None
    names: list[str] = field(default_factory=list)
    source: str = ""
    frames_per_second: float | None = None

    def __len__(self) -> int:
        """Count the frames."""
        return len(self.x)
