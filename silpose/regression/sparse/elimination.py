"""Reach a target sparsity: raise ν, then remove columns by backward elimination."""

from __future__ import annotations

import numpy as np

from silpose.core.cholesky import cholesky_inverse
from silpose.core.types import Indices
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.sparse.first_bridges import FirstBridges
from silpose.regression.sparse.quadratic_bridges import (
    START_DAMPING,
    Bridges,
    minimise_with_bridges,
)

_MARGIN = 0.1  # share of all columns, beyond the target, that the bridges leave to elimination
_STEP = 2.0  # factor between consecutive ν's
_STEPS = 12  # weaker ν's that are tried at most
_DAMPING = 0.1  # of the regression in which columns are compared
_TOGETHER = 48  # columns whose removal changes the whole inverse at once


def sparsest_within(
    first: FirstBridges, count: int, nu: float, max_iter: int, tol: float
) -> tuple[float, Bridges]:
    """Keep `count` columns: raise ν while many more are kept, then eliminate one by one.

    Bridges alone get stuck: at high ν the columns that survive are those that were large early
    on. They remove most columns, cheaply; backward elimination, exact but cubic in the number of
    columns, removes the rest.

    Parameters
    ----------
    first : FirstBridges
        Where the path begins.
    count : int
        Number of columns to keep.
    nu : float
        First ν of the path.
    max_iter : int
    tol : float
        As for `minimise_with_bridges`.

    Returns
    -------
    nu : float
        The last ν.
    end : Bridges
        Its coefficients are those of ridge regression on the columns kept.
    """
    system = first.system
    size = len(system.gram)
    enough = min(count + min(2 * count, int(_MARGIN * size)), size)
    state = first.end(nu, max_iter, tol)
    for _ in range(_STEPS):  # the first ν may be too strong
        if len(state.kept) >= enough:
            break
        nu /= _STEP
        state = first.end(nu, max_iter, tol)
    while len(state.kept) > _STEP * enough:
        nu *= _STEP
        state = minimise_with_bridges(system, state, nu, max_iter, tol)
    kept = eliminate(system, state.kept, count)
    fitted = system.restrict(kept)
    damping = np.full(len(kept), START_DAMPING)
    return nu, Bridges(kept, fitted.solve(damping), damping, state.history)


def eliminate(system: NormalEquations, kept: Indices, count: int) -> Indices:
    """Remove columns one by one, always the one whose loss raises the squared error least.

    Parameters
    ----------
    system : NormalEquations
    kept : ndarray of int, shape (k,)
        Columns to begin with.
    count : int
        Number of columns to keep.

    Returns
    -------
    kept : ndarray of int, shape (count,)
    """
    while len(kept) > count:
        removed = min(len(kept) - count, 1 + len(kept) // 5)  # then anew, with smaller matrices
        kept = _remove(system, kept, removed)
    return kept


def _remove(system: NormalEquations, kept: Indices, number: int) -> Indices:
    """Remove some columns, by updates of one inverse that are of rank one."""
    # With P the inverse of the damped Gram matrix, losing a column raises the damped squared error
    # by ‖a_k‖² / P_kk, and subtracts u uᵀ, u = P_:k / √P_kk, from P. What is needed next is its
    # diagonal and one column: the whole is changed for many u at once, by one matrix product.
    gram = system.gram_among(kept)
    gram.flat[:: len(gram) + 1] += _DAMPING
    inverse = cholesky_inverse(gram)
    diagonal = inverse.diagonal().copy()
    a = inverse @ system.target[kept]
    alive = np.ones(len(kept), dtype=bool)
    waiting = np.empty((len(kept), min(_TOGETHER, number)), order="F")
    count = 0
    for _ in range(number):
        cost = np.where(alive, np.einsum("km,km->k", a, a) / diagonal, np.inf)
        k = int(cost.argmin())
        alive[k] = False
        column = inverse[:, k] - waiting[:, :count] @ waiting[k, :count]
        a -= (column / column[k])[:, None] * a[k]
        column /= np.sqrt(column[k])
        diagonal -= column**2
        diagonal[k] = 1.0  # already removed
        waiting[:, count] = column
        count += 1
        if count == waiting.shape[1]:
            inverse -= waiting @ waiting.T
            count = 0
    return kept[alive]
