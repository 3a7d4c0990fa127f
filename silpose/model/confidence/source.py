"""Doubt about a whole source: frames that look usual among many that do not."""

from __future__ import annotations

import numpy as np
from scipy.special import expit, logit

from silpose.core.types import Array
from silpose.silhouette.person import MaskFacts

_ENOUGH = 5  # whole masks, from which a source is judged
_SURE = 1e-6  # from 0 and 1, so that odds are finite


def doubted_as_a_source(confidence: Array, facts: MaskFacts) -> Array:
    """Lower confidence where most masks of a source look like nothing that trained.

    What makes most masks odd (they are upside down, stretched, or show something else) is in the
    others, too, even if these look like masks of training. Where the median of the log odds is
    negative, it is therefore added to those of each frame. Masks that the picture's border cuts
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
        Nowhere higher; as it was where few whole masks show a person, or most look usual.
    """
    whole = facts.seen & ~facts.cut & np.isfinite(confidence)
    if whole.sum() < _ENOUGH:
        return confidence
    odds = logit(np.clip(confidence, _SURE, 1 - _SURE))
    usual = float(np.median(odds[whole]))
    if usual >= 0:
        return confidence
    return np.where(facts.seen, np.minimum(confidence, expit(odds + usual)), confidence)
