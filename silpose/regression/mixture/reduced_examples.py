"""Examples as components see them, reduced and standardised: in memory, or in blocks.

Both answer alike, to rounding. Blocks are read anew in every pass, on the workers of
`silpose.core.parallel`; their sums are added up in order.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from copy import deepcopy
from dataclasses import dataclass
from functools import partial
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.core.parallel import parallel_in_order
from silpose.core.types import Array
from silpose.regression.blocks import Block, Blocks, read_block
from silpose.regression.mixture.em import Expectation
from silpose.regression.mixture.expert_sums import ExpertSums
from silpose.regression.mixture.experts import Experts
from silpose.regression.mixture.reduction import PoseDirections
from silpose.regression.mixture.shared_regressor import SharedFit, SharedRegressor
from silpose.regression.moments import Moments
from silpose.regression.regressor import Regressor

Outcome = TypeVar("Outcome")


@dataclass(frozen=True)
class ReducedArrays:
    """Examples in memory.

    Attributes
    ----------
    inputs, psi, poses : ndarray, shapes (n, d'), (n, d) and (n, D)
        Descriptors, reduced, and standardised poses.
    fit_shared : callable
        From a regressor, inputs and poses to what is `SharedFit.of` them.
    """

    inputs: Array
    psi: Array
    poses: Array
    fit_shared: Callable[[Regressor, Array, Array], SharedFit]

    @property
    def count(self) -> int:
        """Number of examples."""
        return len(self.psi)

    def expect(self, experts: Experts) -> Expectation:
        """Compute the responsibilities: the E-step."""
        shares, total = experts.responsibilities(self.psi, self.poses)

        def sums(large: NDArray[np.bool_]) -> ExpertSums:
            return ExpertSums.of(self.psi, self.poses, among(shares, large))

        return Expectation(shares.sum(axis=0), total, sums)

    def moments(self) -> tuple[Array, Array]:
        """Mean and variance of ψ, each (d,)."""
        return self.psi.mean(axis=0), self.psi.var(axis=0)

    def share(self, regressor: Regressor, experts: Experts) -> SharedRegressor:
        """Fit a regressor to all examples, and measure its errors near each component."""
        shares, _ = experts.responsibilities(self.psi, self.poses)
        return SharedRegressor.within(self.fit_shared(regressor, self.inputs, self.poses), shares)


@dataclass(frozen=True)
class ReducedBlocks:
    """Blocks of examples, of which few are in memory at once.

    Attributes
    ----------
    blocks : sequence
        As of `silpose.regression.blocks`.
    count : int
        Number of examples.
    reduction : PoseDirections
    mean, scale : ndarray, shape (D,)
        By which poses are standardised.
    """

    blocks: Blocks
    count: int
    reduction: PoseDirections
    mean: Array
    scale: Array

    def expect(self, experts: Experts) -> Expectation:
        """Compute the responsibilities: the E-step."""
        every = np.ones(len(experts.log_shares), dtype=bool)
        whole, total = self._sums(experts, every)

        def sums(large: NDArray[np.bool_]) -> ExpertSums:
            return whole if large.all() else self._sums(experts, large)[0]

        return Expectation(whole.size, total, sums)

    def moments(self) -> tuple[Array, Array]:
        """Mean and variance of ψ, each (d,)."""
        whole = Moments.total(self._map(_input_moments))
        return whole.mean_y, whole.squares / whole.count

    def share(self, regressor: Regressor, experts: Experts) -> SharedRegressor:
        """Fit a regressor to all examples, and measure its errors near each component."""
        pairs = [
            partial(_standardised, self.mean, self.scale, numbered)
            for numbered in enumerate(self.blocks)
        ]
        fitted = clone(regressor).fit_blocks(pairs)
        count, outputs = experts.offsets.shape
        sizes, near, every = np.zeros(count), np.zeros((count, outputs)), np.zeros(outputs)
        for size, weighted, squares in self._map(partial(_errors, fitted, experts)):
            sizes, near, every = sizes + size, near + weighted, every + squares
        return SharedRegressor.of(fitted, sizes, near, every / self.count)

    def _sums(self, experts: Experts, large: NDArray[np.bool_]) -> tuple[ExpertSums, float]:
        whole: ExpertSums | None = None
        log_likelihood = 0.0
        for sums, own in self._map(partial(_expect, experts, large)):
            log_likelihood += own
            if whole is None:
                whole = deepcopy(sums)
            else:
                whole.add(sums)
        assert whole is not None
        return whole, log_likelihood

    def _map(self, function: Callable[[Array, Array, Array], Outcome]) -> Iterator[Outcome]:
        call = partial(_reduced, self.reduction, self.mean, self.scale, function)
        return parallel_in_order(call, list(enumerate(self.blocks)), description="blocks")


def among(shares: Array, large: NDArray[np.bool_]) -> Array:
    """Divide the responsibilities (n, K) of pruned components among the others."""
    if large.all():
        return shares
    shares = shares[:, large]
    total = shares.sum(axis=1, keepdims=True)
    return np.where(total > 0, shares / np.where(total > 0, total, 1), 1 / large.sum())


def _standardised(mean: Array, scale: Array, numbered: tuple[int, Block]) -> tuple[Array, Array]:
    z, x = read_block(numbered)
    return z, (x - mean) / scale


def _reduced(
    reduction: PoseDirections,
    mean: Array,
    scale: Array,
    function: Callable[[Array, Array, Array], Outcome],
    numbered: tuple[int, Block],
) -> Outcome:
    z, x = _standardised(mean, scale, numbered)
    return function(z, reduction.transform(z), x)


def _input_moments(_: Array, psi: Array, poses: Array) -> Moments:
    return Moments.of_outputs(psi)


def _expect(
    experts: Experts, large: NDArray[np.bool_], _: Array, psi: Array, poses: Array
) -> tuple[ExpertSums, float]:
    shares, log_likelihood = experts.responsibilities(psi, poses)
    return ExpertSums.of(psi, poses, among(shares, large)), log_likelihood


def _errors(
    regressor: Regressor, experts: Experts, z: Array, psi: Array, poses: Array
) -> tuple[Array, Array, Array]:
    shares, _ = experts.responsibilities(psi, poses)
    squares = (regressor.predict(z) - poses) ** 2
    return shares.sum(axis=0), shares.T @ squares, squares.sum(axis=0)
