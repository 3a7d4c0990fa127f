"""Doubt about a source: frames that look usual among others that do not."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.special import expit, logit

from silpose.core.types import Array
from silpose.silhouette.person import MaskFacts

_ENOUGH = 5  # whole masks, from which a source is judged
_SURE = 1e-6  # from 0 and 1, so that odds are finite


def doubted_as_a_source(confidence: Array, facts: MaskFacts) -> Array:
    """Lower confidence where other masks of the source look like nothing that trained.

    What damages a frame damages its neighbours: where both are less sure, the surer one counts.
    And what makes most masks odd (they are upside down, stretched, or show something else) is in
    the others, too, even if these look like masks of training: where the median of the log odds
    is negative, it is therefore added to those of each frame. Masks that the picture's border cuts
    are odd by themselves, and do not count in the median.

    Parameters
    ----------
    confidence : ndarray, shape (F,)
        Of each frame by itself.
    facts : MaskFacts
        Of the masks.

    Returns
    -------
    confidence : ndarray, shape (F,)
        Nowhere higher.
    """
    confidence = _as_neighbours(confidence, facts.seen)
    whole = facts.seen & ~facts.cut & np.isfinite(confidence)
    if whole.sum() < _ENOUGH:
        return confidence
    odds = logit(np.clip(confidence, _SURE, 1 - _SURE))
    usual = float(np.median(odds[whole]))
    if usual >= 0:
        return confidence
    return np.where(facts.seen, np.minimum(confidence, expit(odds + usual)), confidence)


def _as_neighbours(confidence: Array, seen: NDArray[np.bool_]) -> Array:
    """Limit confidence (F,) to that of the surer neighbour, where both show somebody."""
    limited = confidence.copy()
    before, after = confidence[:-2], confidence[2:]
    between = seen[:-2] & seen[1:-1] & seen[2:]
    limited[1:-1][between] = np.fmin(confidence[1:-1], np.fmax(before, after))[between]
    return limited
