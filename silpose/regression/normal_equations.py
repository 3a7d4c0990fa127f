"""The least squares problem that ridge and RVM share, reduced to its normal equations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from silpose.core.cholesky import NotPositiveDefinite, cholesky_in_place, cholesky_solve
from silpose.core.compiled import compiled
from silpose.core.types import Array, Indices
from silpose.regression.moments import Moments


@dataclass(frozen=True)
class NormalEquations:
    """Gram matrix and right-hand side of min ‖F A - Y‖², rows of F and Y being examples.

    F and Y are centred, which leaves the offset b undamped, and Y is scaled to unit variance.

    Attributes
    ----------
    gram : ndarray, shape (p, p)
        FᵀF.
    target : ndarray, shape (p, m)
        FᵀY.
    power : ndarray, shape (m,)
        Squared norm of each output: the squared error of A = 0.
    count : int
        Number of examples.
    mean_f : ndarray, shape (p,)
        Means of the basis functions, which were subtracted.
    mean_y, scale_y : ndarray, shape (m,)
        Means and standard deviations of the outputs, which were standardised.
    """

    gram: Array
    target: Array
    power: Array
    count: int
    mean_f: Array
    mean_y: Array
    scale_y: Array

    @classmethod
    def of(cls, f: Array, y: Array) -> NormalEquations:
        """Reduce basis functions and outputs.

        Parameters
        ----------
        f : ndarray, shape (n, p)
        y : ndarray, shape (n, m)
        """
        return cls.from_moments(Moments.of(f, y))

    @classmethod
    def from_moments(cls, moments: Moments) -> NormalEquations:
        """Take over sums over examples, which may have been added up block by block."""
        scale, varies = moments.scales
        # A constant output stays as it is; what rounding leaves of its variance is not blown up.
        return cls(
            moments.gram,
            np.where(varies, moments.cross / scale, 0.0),
            np.where(varies, moments.squares / scale**2, 0.0),
            moments.count,
            moments.mean_f,
            moments.mean_y,
            scale,
        )

    def gram_among(self, kept: Indices) -> Array:
        """Copy the Gram matrix of some of the basis functions."""
        if len(kept) == len(self.gram):
            return self.gram.copy()
        some = np.empty((len(kept), len(kept)))
        _gather(self.gram, kept, some)
        return some

    def solve(self, damping: float | Array) -> Array:
        """Minimise ‖F A - Y‖² + Σ_k damping_k ‖a_k‖², a_k being the k-th row of A (p, m)."""
        return solve_damped(self.gram.copy(), self.target, damping)

    def restrict(self, kept: Indices) -> NormalEquations:
        """Return the problem with some of the basis functions only."""
        return NormalEquations(
            self.gram_among(kept),
            self.target[kept],
            self.power,
            self.count,
            self.mean_f[kept],
            self.mean_y,
            self.scale_y,
        )

    def output(self, j: int) -> NormalEquations:
        """Return the problem of one output."""
        return NormalEquations(
            self.gram,
            self.target[:, [j]],
            self.power[[j]],
            self.count,
            self.mean_f,
            self.mean_y[[j]],
            self.scale_y[[j]],
        )

    def unscaled(self, a: Array, kept: Indices | slice) -> tuple[Array, Array]:
        """Turn a solution into coefficients and offset for the raw f and y.

        Parameters
        ----------
        a : ndarray, shape (k, m)
            Rows of A that are kept.
        kept : ndarray of int, shape (k,), or slice
            Which rows these are.

        Returns
        -------
        coefficients : ndarray, shape (k, m)
        offset : ndarray, shape (m,)
        """
        coefficients = a * self.scale_y
        return coefficients, self.mean_y - self.mean_f[kept] @ coefficients


@compiled()
def _gather(matrix: Array, kept: Indices, some: Array) -> None:
    """Write rows and columns of a matrix, in a third of the time that indexing takes."""
    for i in range(len(kept)):
        row = kept[i]
        for j in range(len(kept)):
            some[i, j] = matrix[row, kept[j]]


def solve_damped(matrix: Array, target: Array, damping: float | Array) -> Array:
    """Solve (M + diag(damping)) A = T.

    Parameters
    ----------
    matrix : ndarray, shape (p, p)
        M, symmetric, contiguous by rows; overwritten.
    target : ndarray, shape (p, m)
        T.
    damping : float or ndarray, shape (p,)

    Returns
    -------
    a : ndarray, shape (p, m)
    """
    diagonal = matrix.diagonal().copy()
    matrix.flat[:: len(matrix) + 1] += damping
    try:
        return cholesky_solve(cholesky_in_place(matrix), target)
    except NotPositiveDefinite:
        return _solve_singular(matrix, diagonal, target, damping)


def _solve_singular(matrix: Array, diagonal: Array, target: Array, damping: float | Array) -> Array:
    """Raise the damping by a few roundings of the largest diagonal entry until it can be solved.

    That happens for near-duplicate examples. The upper half of the matrix was overwritten; the
    lower half and the diagonal are intact.
    """
    whole = np.tril(matrix, -1)
    whole += whole.T
    extra = 1e-14 * float(diagonal.max()) + 1e-300
    while True:
        whole.flat[:: len(whole) + 1] = diagonal + damping + extra
        try:
            factor = cholesky_in_place(whole.copy())
        except NotPositiveDefinite:
            extra *= 10
            continue
        return cholesky_solve(factor, target)
