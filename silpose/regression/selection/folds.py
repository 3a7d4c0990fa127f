"""Folds of cross-validation: over takes, never over frames."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Array, Examples


@dataclass(frozen=True, eq=False)
class Fold:
    """Training takes, and held-out takes for validation; compared by identity.

    Attributes
    ----------
    train, validation : sequence of (z, x)
        Descriptors (F, d) and poses (F, D) of each take.
    """

    train: Examples
    validation: Examples

    @cached_property
    def z(self) -> Array:
        """All training descriptors, shape (n, d)."""
        return np.concatenate([z for z, _ in self.train])

    @cached_property
    def x(self) -> Array:
        """All training poses, shape (n, D)."""
        return np.concatenate([x for _, x in self.train])

    @cached_property
    def z_validation(self) -> Array:
        """All held-out descriptors, shape (m, d)."""
        return np.concatenate([z for z, _ in self.validation])

    @cached_property
    def x_validation(self) -> Array:
        """All held-out poses, shape (m, D)."""
        return np.concatenate([x for _, x in self.validation])

    @property
    def frames(self) -> int:
        """Number of held-out frames."""
        return sum(len(x) for _, x in self.validation)


def partition(
    lengths: Sequence[int], most: int, groups: Sequence[str] | None = None
) -> list[set[int]]:
    """Partition training takes into parts, each of which is held out once.

    Parameters
    ----------
    lengths : sequence of int
        Frames of each take.
    most : int
        Largest number of parts, which are of about equal size.
    groups : sequence of str, optional
        Group of each take, such as its performer; each group is a part of its own.

    Returns
    -------
    parts : list of set of int
        Indices of takes, two parts or more.

    Raises
    ------
    InputError
        If there is but one take, or one group.
    """
    if groups is not None:
        parts = [{k for k, g in enumerate(groups) if g == own} for own in sorted(set(groups))]
    else:
        parts = [set() for _ in range(min(most, len(lengths)))]
        for k in sorted(range(len(lengths)), key=lambda k: -lengths[k]):  # the longest first
            min(parts, key=lambda part: sum(lengths[i] for i in part)).add(k)
    if len(parts) < 2:
        what = "takes" if groups is None else "groups of takes"
        raise InputError(f"choosing settings needs a validation take, or two {what} for training")
    return parts


def folds(
    train: Examples,
    validation: Examples = (),
    *,
    most: int = 8,
    groups: Sequence[str] | None = None,
) -> list[Fold]:
    """Pair training takes with held-out takes.

    Parameters
    ----------
    train, validation : sequence of (z, x)
        Descriptors and poses of each take. If there are validation takes, these are held out;
        otherwise every training take is held out in one of the folds.
    most : int, default=8
        Largest number of folds, without validation takes and groups.
    groups : sequence of str, optional
        Group of each training take; without validation takes, each group is held out once.

    Returns
    -------
    folds : list of Fold
    """
    if validation:
        return [Fold(train, validation)]
    return [
        Fold(
            [take for k, take in enumerate(train) if k not in part],
            [train[k] for k in sorted(part)],
        )
        for part in partition([len(x) for _, x in train], most, groups)
    ]
