"""What a regressor fits to: examples in memory, or blocks of them that are read when needed.

Both answer the same three questions, and to rounding alike: which settings are best, which basis
functions there are, and what the normal equations of these are.
"""

from __future__ import annotations

from collections.abc import Iterator
from copy import deepcopy
from functools import partial
from typing import Protocol

import numpy as np
from sklearn.base import clone

from silpose.core.errors import InputError
from silpose.core.parallel import parallel_in_order
from silpose.core.types import Array, Indices
from silpose.regression.automatic import Chosen, choose, choose_among, compared_rows
from silpose.regression.basis import Basis
from silpose.regression.blocks import Block, Blocks, read_block, read_rows
from silpose.regression.hellinger import square_roots
from silpose.regression.kernels import sampled_rows
from silpose.regression.moments import Moments
from silpose.regression.normal_equations import NormalEquations


class TrainingExamples(Protocol):
    """Inputs z and outputs x of training."""

    def choose(self, basis: Basis) -> Chosen:
        """Choose damping, and width where it is "auto", by leave-one-out."""

    def fit(self, basis: Basis) -> Basis:
        """Choose the centres and the scale of a basis."""

    def equations(self, basis: Basis) -> NormalEquations:
        """Reduce examples to the normal equations of a fitted basis."""


class ArrayExamples:
    """Examples in memory.

    Parameters
    ----------
    z, x : ndarray, shapes (n, d) and (n, m)
    """

    def __init__(self, z: Array, x: Array) -> None:
        self.z, self.x = z, x

    def choose(self, basis: Basis) -> Chosen:
        """Choose damping, and width where it is "auto", by leave-one-out."""
        return choose(basis, self.z, self.x)

    def fit(self, basis: Basis) -> Basis:
        """Choose the centres and the scale of a basis."""
        return basis.fit(self.z)

    def equations(self, basis: Basis) -> NormalEquations:
        """Reduce examples to the normal equations of a fitted basis."""
        return NormalEquations.of(basis.evaluate(self.z), self.x)


class StreamedExamples:
    """Blocks of examples, of which few are in memory at once.

    Parameters
    ----------
    blocks : sequence
        As of `silpose.regression.blocks`.
    hellinger : bool
        Whether bases take square roots of inputs.

    Attributes
    ----------
    whole : Moments
        Of the inputs, or their square roots, in place of basis functions.

    Raises
    ------
    InputError
        If a block cannot be used: all are read once.
    """

    def __init__(self, blocks: Blocks, hellinger: bool) -> None:
        if not len(blocks):
            raise InputError("there is no block to fit to: give one or more")
        self._blocks, self._hellinger = blocks, hellinger
        self.whole, counts = self._total(partial(_survey, hellinger))
        self._starts = np.concatenate([[0], np.cumsum(counts)[:-1]]).astype(np.intp)

    def choose(self, basis: Basis) -> Chosen:
        """Choose damping, and width where it is "auto", by leave-one-out."""
        z, x = self.read(compared_rows(self.whole.count))
        scale, varies = self.whole.scales
        return choose_among(basis, z, (x - self.whole.mean_y) / scale, varies)

    def fit(self, basis: Basis) -> Basis:
        """Choose the centres and the scale of a basis."""
        whole = self.whole
        rows = basis.choose_rows(whole.count, self._inputs)
        sampled = sampled_rows(whole.count)
        needed = np.union1d(rows, sampled)
        inputs = basis.roots(self.read(needed)[0])
        centres, sample = (inputs[np.searchsorted(needed, own)] for own in (rows, sampled))
        variance = whole.gram.diagonal() / whole.count
        return clone(basis).use_fitted(rows, centres, whole.mean_f, variance, sample)

    def equations(self, basis: Basis) -> NormalEquations:
        """Reduce examples to the normal equations of a fitted basis."""
        return NormalEquations.from_moments(self._total(partial(_accumulate, basis))[0])

    def read(self, rows: Indices) -> tuple[Array, Array]:
        """Gather some rows of inputs and outputs, which are in order."""
        return read_rows(self._blocks, self._starts, rows)

    def _total(self, function: partial[Moments]) -> tuple[Moments, list[int]]:
        """Add up the sums of all blocks, in their order; and count each one's examples."""
        whole: Moments | None = None
        counts: list[int] = []
        blocks = list(enumerate(self._blocks))
        for moments in parallel_in_order(function, blocks, description="blocks"):
            whole = _added(whole, moments, len(counts))
            counts.append(moments.count)
        assert whole is not None
        return whole, counts

    def _inputs(self) -> Iterator[Array]:
        for numbered in enumerate(self._blocks):
            z, _ = read_block(numbered)
            yield square_roots(z) if self._hellinger else z


def _survey(hellinger: bool, numbered: tuple[int, Block]) -> Moments:
    z, x = read_block(numbered)
    return Moments.of(square_roots(z) if hellinger else z, x)


def _accumulate(basis: Basis, numbered: tuple[int, Block]) -> Moments:
    z, x = read_block(numbered)
    return Moments.of(basis.evaluate(z), x)


def _added(whole: Moments | None, moments: Moments, index: int) -> Moments:
    if whole is None:
        return deepcopy(moments)  # what comes from a worker may be read-only
    if moments.cross.shape != whole.cross.shape:
        raise InputError(
            f"block {index} has {moments.cross.shape[0]} inputs and {moments.cross.shape[1]} "
            f"outputs, the blocks before it {whole.cross.shape[0]} and {whole.cross.shape[1]}: "
            "make all blocks with the same descriptor and pose space"
        )
    whole.add(moments)
    return whole
