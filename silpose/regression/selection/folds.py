"""Folds of cross-validation: over sequences, never over frames."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError

Array = NDArray[np.float64]
Examples = Sequence[tuple[Array, Array]]


def partition(
    lengths: Sequence[int], most: int, groups: Sequence[str] | None = None
) -> list[set[int]]:
    """Deal training sequences into parts that are left out by turns.

    Parameters
    ----------
    lengths : sequence of int
        Of the sequences, frames.
    most : int
        Parts, of about equal size, if there are more sequences.
    groups : sequence of str, optional
        Of each sequence, such as its performer; each group is a part of its own.

    Returns
    -------
    parts : list of set of int
        Which sequences, two parts or more.
    """
    if groups is not None:
        parts = [{k for k, g in enumerate(groups) if g == own} for own in sorted(set(groups))]
    else:
        parts = [set() for _ in range(min(most, len(lengths)))]
        for k in sorted(range(len(lengths)), key=lambda k: -lengths[k]):  # the longest first
            min(parts, key=lambda part: sum(lengths[i] for i in part)).add(k)
    if len(parts) < 2:
        raise InputError("choosing settings needs a validation sequence, or two for training")
    return parts


def folds(
    train: Examples,
    validation: Examples = (),
    most: int = 8,
    groups: Sequence[str] | None = None,
) -> list[tuple[Examples, Examples]]:
    """Pair sequences to learn from with sequences to judge by.

    Parameters
    ----------
    train, validation : sequence of (z, x)
        Descriptors and poses of each sequence. Where there are validation sequences, they judge;
        else the training sequences take turns.
    most, groups
        As for `partition`.

    Returns
    -------
    pairs : list of (learnt from, judged by)
    """
    if validation:
        return [(train, validation)]
    return [
        (
            [sequence for k, sequence in enumerate(train) if k not in part],
            [train[k] for k in sorted(part)],
        )
        for part in partition([len(x) for _, x in train], most, groups)
    ]
