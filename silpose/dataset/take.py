"""Sequences: what is learnt from and tested on."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.core.pose_space import PoseSpace
from silpose.dataset.lazy_masks import LazyMasks
from silpose.silhouette import Camera

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Take:
    """One continuous take.

    Attributes
    ----------
    name, performer : str
    frames_per_second : float
    x : ndarray, shape (F, D)
        True poses.
    masks : ndarray of 0 and 1, shape (F, H, W), or LazyMasks, or None
        Held, or taken when they are asked for.
    offset : ndarray, shape (F, 3)
        Of the root from what the camera looks at, metres.
    z : ndarray, shape (F, d), or None
        Descriptors, where these are what the data hold instead of masks.
    take : str or None
        What was photographed, where one take gave several sequences.
    camera : Camera or None
        Which took the masks.
    """

    name: str
    performer: str
    frames_per_second: float
    x: Array
    masks: NDArray[np.uint8] | LazyMasks | None
    offset: Array
    z: Array | None = None
    take: str | None = None
    camera: Camera | None = None

    def __len__(self) -> int:
        return len(self.x)


@dataclass(frozen=True)
class Dataset:
    """Sequences by what they are for; no take may be in two of the lists.

    Attributes
    ----------
    name : str
    space : PoseSpace
    train, validation, test : sequence of Take
    by_performer : bool
        Whether no performer may be in two of the lists either, and hyper-parameters are chosen by
        leaving one performer out at a time.
    """

    name: str
    space: PoseSpace
    train: Sequence[Take]
    validation: Sequence[Take]
    test: Sequence[Take]
    by_performer: bool = False

    def __post_init__(self) -> None:
        self._refuse_twice("take", lambda sequence: sequence.take or sequence.name)
        if self.by_performer:
            self._refuse_twice("performer", lambda sequence: sequence.performer)
        names = [s.name for part in (self.train, self.validation, self.test) for s in part]
        if len(set(names)) < len(names):
            twice = next(name for name in names if names.count(name) > 1)
            raise InputError(f"two sequences are called '{twice}'")

    def _refuse_twice(self, what: str, which: Callable[[Take], str]) -> None:
        parts = [{which(s) for s in part} for part in (self.train, self.validation, self.test)]
        for one, other in combinations(parts, 2):
            if one & other:
                raise InputError(
                    f"{what} '{min(one & other)}' is in two of training, validation and test"
                )


def poses(sequences: Iterable[Take]) -> Array:
    """All poses of some sequences, shape (n, D)."""
    return np.concatenate([s.x for s in sequences])
