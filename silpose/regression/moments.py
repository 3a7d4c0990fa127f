"""Sums over examples that add up block by block: all that least squares needs of the examples.

Each block is centred by its own means, and means are allowed for when sums are added, so that
nothing is lost by cancellation: T. F. Chan, G. H. Golub, R. J. LeVeque, "Algorithms for computing
the sample variance", The American Statistician 1983. Their size depends on the number of basis
functions, not on that of the examples.
"""

from __future__ import annotations

from collections.abc import Iterable
from copy import deepcopy
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Array
from silpose.regression.scales import scales_from


@dataclass
class Moments:
    """Means, and sums of products of deviations from them, of basis functions and outputs.

    Attributes
    ----------
    count : int
        Number of examples.
    mean_f, mean_y : ndarray, shapes (p,) and (m,)
    gram : ndarray, shape (p, p)
        FᵀF, F centred.
    cross : ndarray, shape (p, m)
        FᵀY, both centred.
    squares : ndarray, shape (m,)
        Squared norm of each centred output.
    low, high : ndarray, shape (m,)
        Range of each output.
    """

    count: int
    mean_f: Array
    mean_y: Array
    gram: Array
    cross: Array
    squares: Array
    low: Array
    high: Array

    @classmethod
    def of(cls, f: Array, y: Array) -> Moments:
        """Sum over examples.

        Parameters
        ----------
        f : ndarray, shape (n, p)
        y : ndarray, shape (n, m)
        """
        mean_f, mean_y = f.mean(axis=0), y.mean(axis=0)
        centred, off = f - mean_f, y - mean_y
        squares = (off**2).sum(axis=0)
        gram, cross = centred.T @ centred, centred.T @ off
        return cls(len(f), mean_f, mean_y, gram, cross, squares, y.min(axis=0), y.max(axis=0))

    @classmethod
    def total(cls, parts: Iterable[Moments]) -> Moments:
        """Add up the sums over blocks of examples, one or more."""
        whole: Moments | None = None
        for moments in parts:
            if whole is None:
                whole = deepcopy(moments)  # what comes from a worker may be read-only
            else:
                whole.add(moments)
        assert whole is not None
        return whole

    @classmethod
    def of_outputs(cls, y: Array) -> Moments:
        """Sum over outputs (n, m) alone, without basis functions."""
        return cls.of(y[:, :0], y)

    def add(self, other: Moments) -> None:
        """Add the examples of a block more."""
        count = self.count + other.count
        weight = self.count * other.count / count
        step_f, step_y = other.mean_f - self.mean_f, other.mean_y - self.mean_y
        self.gram += other.gram
        self.gram += np.outer(weight * step_f, step_f)
        self.cross += other.cross
        self.cross += np.outer(weight * step_f, step_y)
        self.squares += other.squares + weight * step_y**2
        self.mean_f = self.mean_f + other.count / count * step_f
        self.mean_y = self.mean_y + other.count / count * step_y
        self.low, self.high = np.minimum(self.low, other.low), np.maximum(self.high, other.high)
        self.count = count

    @property
    def scales(self) -> tuple[Array, NDArray[np.bool_]]:
        """Standard deviation of each output, 1 for constant ones, and whether it varies."""
        return scales_from(np.sqrt(self.squares / self.count), self.low, self.high)
