"""Folds of cross-validation: over sequences, never over frames."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from silpose.errors import InputError

Array = NDArray[np.float64]
Examples = Sequence[tuple[Array, Array]]

FOLDS = 8


def folds(train: Examples, validation: Examples = ()) -> list[tuple[Examples, Examples]]:
    """Pair sequences to learn from with sequences to judge by.

    Parameters
    ----------
    train, validation : sequence of (z, x)
        Descriptors and poses of each sequence. Where there are validation sequences, they judge;
        else the training sequences take turns, each on its own, or if they are many in folds of
        about equal size.

    Returns
    -------
    pairs : list of (learnt from, judged by)
    """
    if validation:
        return [(train, validation)]
    if len(train) < 2:
        raise InputError("choosing settings needs a validation sequence, or two for training")
    parts: list[list[int]] = [[] for _ in range(min(FOLDS, len(train)))]
    for k in sorted(range(len(train)), key=lambda k: -len(train[k][0])):  # the longest first
        min(parts, key=lambda part: sum(len(train[i][0]) for i in part)).append(k)
    return [
        ([t for k, t in enumerate(train) if k not in part], [train[k] for k in part])
        for part in parts
    ]
