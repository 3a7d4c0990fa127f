"""What trackers return."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Track:
    """A sequence's estimates.

    Attributes
    ----------
    x : ndarray, shape (F, D)
    state : list of str
        One of `belief.STATES` for each frame.
    beliefs : ndarray, shape (F, K)
        Over key poses: the activations of the state-sensitive basis, summing to 1.
    """

    x: Array
    state: list[str]
    beliefs: Array


@dataclass(frozen=True)
class ManyTracks:
    """A sequence's estimates, several for each frame.

    Attributes
    ----------
    x : ndarray, shape (F, D)
        Regressed around the most probable mode.
    state : list of str
        One of `belief.STATES` for each frame.
    weights : ndarray, shape (F, k)
        Of the hypotheses' modes, the most probable first; 0 where there are less.
    means : ndarray, shape (F, k, D)
    """

    x: Array
    state: list[str]
    weights: Array
    means: Array
