"""Kernel width and damping by leave-one-out in closed form, without a grid of the user's.

Leaving out an example takes its row out of F, and the kernel that it carries as well: a kernel at
the very point that is to be predicted would not be there for a new one. Both are changes of rank
one, so that a single decomposition of F gives the errors at all dampings.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh
from sklearn.base import clone

from silpose.core.types import Array, Indices
from silpose.regression.basis import Basis
from silpose.regression.scales import scales_of

WIDTHS = tuple(2.0**k for k in range(-4, 6))
DAMPINGS = tuple(float(d) for d in np.geomspace(1e-4, 1e3, 29))
_MOST = 600  # examples on which settings are compared; of more, an even share


@dataclass(frozen=True)
class Chosen:
    """The settings whose leave-one-out error is least.

    Attributes
    ----------
    basis : Basis
        Not fitted, its width a number.
    damping : float
    noise : ndarray, shape (m,)
        Mean squared leave-one-out error of each output, of unit variance.
    """

    basis: Basis
    damping: float
    noise: Array


def choose(basis: Basis, z: Array, x: Array) -> Chosen:
    """Choose the damping of ridge regression, and the kernels' width where it is "auto".

    Parameters
    ----------
    basis : Basis
        Not fitted.
    z, x : ndarray, shapes (n, d) and (n, m)
    """
    some = compared_rows(len(z))
    mean, scale, varies = scales_of(x)
    return choose_among(basis, z[some], (x[some] - mean) / scale, varies)


def compared_rows(count: int) -> Indices:
    """Return the rows of so many examples on which settings are compared."""
    return np.linspace(0, count - 1, min(count, _MOST)).astype(int)


def choose_among(basis: Basis, z: Array, x: Array, varies: NDArray[np.bool_]) -> Chosen:
    """Choose as `choose` does, from the compared examples, their outputs scaled, and which vary."""
    y = x[:, varies]
    widths = WIDTHS if basis.width == "auto" and basis.kernel else (basis.width,)
    least, found = np.inf, Chosen(_with_width(basis, widths[0]), DAMPINGS[0], np.ones(x.shape[1]))
    if len(z) < 3 or not varies.any():
        return found
    for width in widths:
        candidate = _with_width(basis, width)
        fitted = clone(candidate).fit(z)
        errors = _LeaveOneOut.of(fitted, z, y)
        for damping in DAMPINGS:
            squared = errors.at(damping)
            if (score := float(np.sqrt(squared).mean())) < least:
                least = score
                noise = np.zeros(x.shape[1])
                noise[varies] = squared
                found = Chosen(candidate, damping, noise)
    return found


def _with_width(basis: Basis, width: float | str) -> Basis:
    candidate: Basis = clone(basis)
    return candidate.set_params(width=1.0 if width == "auto" else width)


@dataclass(frozen=True)
class _LeaveOneOut:
    """A decomposition of centred basis functions F = U S Vᵀ, rows of V being functions.

    Attributes
    ----------
    rows, places : ndarray of int
        Examples that carry a kernel, and the columns of F of these.
    """

    left: Array
    squares: Array
    right: Array
    target: Array
    y: Array
    rows: Indices
    places: Indices

    @classmethod
    def of(cls, basis: Basis, z: Array, y: Array) -> _LeaveOneOut:
        f = basis.evaluate(z)
        f = f - f.mean(axis=0)
        y = y - y.mean(axis=0)
        squares, right = eigh(f.T @ f)
        squares = np.maximum(squares, 0)
        left = f @ right  # U S
        rows = basis.indices_
        return cls(left, squares, right, left.T @ y, y, rows, np.arange(len(rows)))

    def at(self, damping: float) -> Array:
        """Mean squared error of each output, shape (m,), examples left out one at a time."""
        inverse = 1 / (self.squares + damping)
        solved = inverse[:, None] * self.target
        free = 1 - 1 / len(self.y) - (self.left**2) @ inverse
        free = np.maximum(free, 1e-10)[:, None]
        off = (self.y - self.left @ solved) / free
        right, left = self.right[self.places], self.left[self.rows]
        beside = ((left * right) @ inverse)[:, None]
        own = ((right**2) @ inverse)[:, None] + beside**2 / free[self.rows]
        a = right @ solved - beside * off[self.rows]
        off[self.rows] += beside / free[self.rows] / own * a
        return np.asarray((off**2).mean(axis=0))
