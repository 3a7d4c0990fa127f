"""Descriptors of whole datasets: masks are described as they are rendered, on all cores."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from functools import partial
from typing import Any, Protocol

import numpy as np
from joblib import parallel_config
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.core.parallel import parallel_map
from silpose.core.progress import bar
from silpose.core.types import Array
from silpose.dataset import LazyMasks, Take
from silpose.descriptor import ShapeContextHistogram

Block = NDArray[np.uint8] | LazyMasks

_BLOCK = 256  # frames whose masks a process holds at a time
_FEW = 4000  # masks to render for which other processes are not worth their start
_CODEBOOK_MASKS = 5000  # to which the codebook is fitted; of more masks, an even share


class Descriptor(Protocol):
    """A transformer from masks to descriptors."""

    def fit(self, masks: Any, y: None = None, /) -> Any: ...  # noqa: D102

    def transform(self, masks: Any, /) -> Array: ...  # noqa: D102


def fit_descriptor(
    descriptor: ShapeContextHistogram, takes: Sequence[Take]
) -> ShapeContextHistogram | None:
    """Fit a descriptor to training masks.

    Parameters
    ----------
    descriptor : ShapeContextHistogram
        Never changed: a copy is fitted.
    takes : sequence of Take

    Returns
    -------
    descriptor : ShapeContextHistogram or None
        None where the takes hold descriptors already.
    """
    masks = [take.masks for take in takes if take.masks is not None]
    if not masks:
        return None
    every = -(-sum(map(len, masks)) // _CODEBOOK_MASKS)
    starts = -np.cumsum([0, *map(len, masks)]) % every  # so that short takes get their share
    samples = [own[s::every] for own, s in zip(masks, starts, strict=False) if s < len(own)]
    return clone(descriptor).fit([mask for own in samples for mask in own])


def describe(descriptor: Descriptor | None, takes: Sequence[Take]) -> list[Array]:
    """Describe every frame of some takes, with a progress bar.

    Parameters
    ----------
    descriptor : transformer of masks, or None
        Fitted; None where the takes hold descriptors.
    takes : sequence of Take

    Returns
    -------
    z : list of ndarray, each (F, d)
        By take. Each process holds no more than a block of masks at a time.
    """
    if descriptor is None:
        return [take.z for take in takes if take.z is not None]
    blocks = [
        take.masks.part(slice(start, start + _BLOCK))
        if isinstance(take.masks, LazyMasks)
        else take.masks[start : start + _BLOCK]
        for take in takes
        if take.masks is not None
        for start in range(0, len(take), _BLOCK)
    ]
    described = _described(descriptor, blocks)
    ends = np.cumsum([len(take) for take in takes])[:-1]
    return np.split(np.concatenate(described), ends) if described else []


def describe_takes(
    descriptor: Descriptor | None, takes: Sequence[Take]
) -> list[tuple[Array, Array]]:
    """Describe some takes: descriptors (F, d), as `describe` gives them, and poses (F, D)."""
    return [(z, take.x) for z, take in zip(describe(descriptor, takes), takes, strict=True)]


def _described(descriptor: Descriptor, blocks: Sequence[Block]) -> list[Array]:
    if sum(len(block) for block in blocks if isinstance(block, LazyMasks)) <= _FEW:
        described = []
        with bar("descriptors", sum(map(len, blocks))) as advance:
            for block in blocks:
                described.append(descriptor.transform(list(block)))
                advance(len(block))
        return described
    # Posing and filling is Python's work, so that threads would wait for each other.
    single, processes = copy(descriptor), -1
    if isinstance(single, ShapeContextHistogram):
        processes = single.n_jobs or -1
        single.set_params(n_jobs=1)
    with parallel_config(n_jobs=processes):
        return parallel_map(partial(_transform, single), blocks, description="descriptors")


def _transform(descriptor: Descriptor, block: Block) -> Array:
    return descriptor.transform(list(block))
