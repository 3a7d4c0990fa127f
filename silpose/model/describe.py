"""Descriptors of whole datasets: masks are described as they are taken, on all cores."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from copy import copy

import numpy as np
from numpy.typing import NDArray
from sklearn.base import clone
from sklearn.utils.parallel import Parallel, delayed

from silpose.core.progress import bar
from silpose.dataset import LazyMasks, Take
from silpose.descriptor import AlignedMask, HuMoments, ShapeContextHistogram

Array = NDArray[np.float64]

Descriptor = ShapeContextHistogram | HuMoments | AlignedMask

_BLOCK = 256  # frames whose masks a process holds at a time
_FEW = 4000  # masks for which other processes are not worth their start
_CODEBOOK_MASKS = 5000  # from which the codebook is learnt; of more masks, an even share


def learn_descriptor(
    descriptor: ShapeContextHistogram, takes: Sequence[Take]
) -> ShapeContextHistogram | None:
    """Fit the descriptor to training masks; None where the data hold descriptors already."""
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
    takes : sequence of Sequence

    Returns
    -------
    z : list of ndarray, each (F, d)
        By take. Not more than a block of masks is held by each process at a time.
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
    with bar("descriptors", sum(map(len, blocks))) as advance:
        done = []
        for z in _described(descriptor, blocks):
            done.append(z)
            advance(len(z))
    ends = np.cumsum([len(take) for take in takes])[:-1]
    return np.split(np.concatenate(done), ends) if done else []


def examples(descriptor: Descriptor | None, takes: Sequence[Take]) -> list[tuple[Array, Array]]:
    """Descriptors (F, d), as `describe` gives them, and poses (F, D) of each take."""
    return [(z, take.x) for z, take in zip(describe(descriptor, takes), takes, strict=True)]


def _described(
    descriptor: Descriptor, blocks: Sequence[NDArray[np.uint8] | LazyMasks]
) -> Iterator[Array]:
    to_take = sum(len(block) for block in blocks if isinstance(block, LazyMasks))
    if to_take <= _FEW:
        return (descriptor.transform(list(block)) for block in blocks)
    # Posing and filling is Python's work, so that threads would wait for each other.
    alone, processes = copy(descriptor), -1
    if isinstance(alone, ShapeContextHistogram):
        processes = descriptor.n_jobs or -1
        alone.set_params(n_jobs=1)
    pool = Parallel(processes, return_as="generator", pre_dispatch="2*n_jobs")
    return pool(delayed(_transform)(alone, block) for block in blocks)


def _transform(descriptor: Descriptor, block: NDArray[np.uint8] | LazyMasks) -> Array:
    return descriptor.transform(list(block))
