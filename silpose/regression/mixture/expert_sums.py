"""Sums over examples, weighted by responsibility, from which all components are fitted.

Those of blocks of examples add up, centred as `silpose.regression.moments` does it. Their size
depends on the number of components, not on that of the examples.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from silpose.core.types import Array

_IGNORED = 1e-6  # responsibility below which an example is left out of a component's regression


@dataclass
class ExpertSums:
    """Sums for K components, over inputs ψ and poses x with responsibilities.

    Attributes
    ----------
    size : ndarray, shape (K,)
        Of responsibilities, over all examples.
    inputs : ndarray, shape (K, d)
        Of weighted ψ, over all examples.
    weight : ndarray, shape (K,)
        Of responsibilities, over the examples that a component does not ignore, as all below.
    mean_f, mean_y : ndarray, shapes (K, d) and (K, D)
        Weighted means of ψ and x.
    gram, cross, squares : ndarray, shapes (K, d, d), (K, d, D) and (K, D)
        Weighted products of deviations from these: ψψᵀ, ψxᵀ, and squares of x.
    """

    size: Array
    inputs: Array
    weight: Array
    mean_f: Array
    mean_y: Array
    gram: Array
    cross: Array
    squares: Array

    @classmethod
    def of(cls, psi: Array, poses: Array, shares: Array) -> ExpertSums:
        """Sum over examples.

        Parameters
        ----------
        psi, poses : ndarray, shapes (n, d) and (n, D)
        shares : ndarray, shape (n, K)
            Responsibility of each component for each example.
        """
        count, d, outputs = shares.shape[1], psi.shape[1], poses.shape[1]
        weight = np.zeros(count)
        mean_f, mean_y, squares = np.zeros((count, d)), *np.zeros((2, count, outputs))
        gram, cross = np.zeros((count, d, d)), np.zeros((count, d, outputs))
        for k, share in enumerate(shares.T):
            own = share > _IGNORED
            if not own.any():
                continue
            w, f, y = share[own, None], psi[own], poses[own]
            weight[k] = w.sum()
            mean_f[k], mean_y[k] = (w * f).sum(axis=0) / weight[k], (w * y).sum(axis=0) / weight[k]
            f, y = f - mean_f[k], y - mean_y[k]
            gram[k], cross[k] = f.T @ (w * f), f.T @ (w * y)
            squares[k] = (w * y**2).sum(axis=0)
        size, inputs = shares.sum(axis=0), shares.T @ psi
        return cls(size, inputs, weight, mean_f, mean_y, gram, cross, squares)

    def add(self, other: ExpertSums) -> None:
        """Add the examples of a block more."""
        weight = self.weight + other.weight
        share = other.weight / np.where(weight > 0, weight, 1)
        both = (self.weight * share)[:, None]
        step_f, step_y = other.mean_f - self.mean_f, other.mean_y - self.mean_y
        self.gram = self.gram + other.gram + (both * step_f)[:, :, None] * step_f[:, None]
        self.cross = self.cross + other.cross + (both * step_f)[:, :, None] * step_y[:, None]
        self.squares = self.squares + other.squares + both * step_y**2
        self.mean_f = self.mean_f + share[:, None] * step_f
        self.mean_y = self.mean_y + share[:, None] * step_y
        self.weight = weight
        self.size, self.inputs = self.size + other.size, self.inputs + other.inputs
