"""Sequences: what is learnt from and tested on."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Sequence as Ordered
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from silpose.errors import InputError
from silpose.pose import PoseSpace

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Sequence:
    """One continuous take.

    Attributes
    ----------
    name, performer : str
    frames_per_second : float
    x : ndarray, shape (F, D)
        True poses.
    masks : ndarray of 0 and 1, shape (F, H, W), or None
    offset : ndarray, shape (F, 3)
        Of the root from what the camera looks at, metres.
    z : ndarray, shape (F, d), or None
        Descriptors, where these are what the data hold instead of masks.
    """

    name: str
    performer: str
    frames_per_second: float
    x: Array
    masks: NDArray[np.uint8] | None
    offset: Array
    z: Array | None = None

    def __len__(self) -> int:
        return len(self.x)


@dataclass(frozen=True)
class Dataset:
    """Sequences by what they are for; no take may be in two of the lists."""

    name: str
    space: PoseSpace
    train: Ordered[Sequence]
    validation: Ordered[Sequence]
    test: Ordered[Sequence]

    def __post_init__(self) -> None:
        names = [s.name for part in (self.train, self.validation, self.test) for s in part]
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise InputError(f"take '{twice[0]}' is in two of training, validation and test")


def poses(sequences: Iterable[Sequence]) -> Array:
    """All poses of some sequences, shape (n, D)."""
    return np.concatenate([s.x for s in sequences])
