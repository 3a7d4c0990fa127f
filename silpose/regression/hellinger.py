"""Square roots of histograms, whose Euclidean distance is the histograms' Hellinger distance."""

from __future__ import annotations

import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Array


def square_roots(inputs: Array) -> Array:
    """Take the square root of every entry.

    Raises
    ------
    InputError
        If one is negative.
    """
    if np.min(inputs) < 0:
        raise InputError(
            "Negative values in data: only histograms have square roots, "
            "other inputs need hellinger=False"
        )
    return np.sqrt(inputs)
