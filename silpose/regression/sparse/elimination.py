"""Coming to a wanted sparsity: by raising ν, then by removing what is missed least."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cho_factor, cho_solve
from scipy.linalg.blas import dger

from silpose.regression.normal_equations import Indices, NormalEquations
from silpose.regression.sparse.quadratic_bridges import (
    START_DAMPING,
    Bridges,
    minimise_with_bridges,
)

Array = NDArray[np.float64]

_MARGIN = 0.1  # share of all columns, beyond those wanted, that the bridges leave to elimination
_STEP = 2.0  # factor between the ν's of the path
_STEPS = 12  # to weaker ν's at most
_DAMPING = 0.1  # of the regression in which columns are compared


def sparsest_within(
    system: NormalEquations, count: int, nu: float, start: Bridges, max_iter: int, tol: float
) -> tuple[float, Bridges]:
    """Keep `count` columns: raise ν while many more are kept, then eliminate one by one.

    Bridges alone get stuck: at high ν the columns that survive are those that were large early
    on. They choose most of what goes, cheaply; backward elimination, exact but cubic in the number
    of columns, chooses the rest.

    Parameters
    ----------
    system : NormalEquations
    count : int
    nu : float
        First ν of the path.
    start : Bridges
        Where it begins.
    max_iter, tol
        As for `minimise_with_bridges`.

    Returns
    -------
    nu : float
        The last.
    end : Bridges
        Its coefficients those of ridge regression on what is kept.
    """
    size = len(start.kept)
    enough = min(count + min(2 * count, int(_MARGIN * size)), size)
    state = minimise_with_bridges(system, start, nu, max_iter, tol)
    for _ in range(_STEPS):  # the first ν may be too strong
        if len(state.kept) >= enough:
            break
        nu /= _STEP
        state = minimise_with_bridges(system, start, nu, max_iter, tol)
    while len(state.kept) > _STEP * enough:
        nu *= _STEP
        state = minimise_with_bridges(system, state, nu, max_iter, tol)
    kept = eliminate(system, state.kept, count)
    fitted = system.restrict(kept)
    damping = np.full(len(kept), START_DAMPING)
    return nu, Bridges(kept, fitted.solve(damping), damping, state.history)


def eliminate(system: NormalEquations, kept: Indices, count: int) -> Indices:
    """Remove columns one by one until `count` are left, always the one that is missed least."""
    while len(kept) > count:
        removed = min(len(kept) - count, 1 + len(kept) // 5)  # then start from smaller matrices
        kept = _remove(system, kept, removed)
    return kept


def _remove(system: NormalEquations, kept: Indices, number: int) -> Indices:
    # With P the inverse of the damped Gram matrix, losing a column raises the damped squared error
    # by ‖a_k‖² / P_kk, and P and A follow by a rank-one update.
    gram = system.gram[np.ix_(kept, kept)]
    gram.flat[:: len(gram) + 1] += _DAMPING
    inverse = np.asfortranarray(cho_solve(cho_factor(gram, lower=True), np.eye(len(gram))))
    a = inverse @ system.target[kept]
    alive = np.ones(len(kept), dtype=bool)
    for _ in range(number):
        cost = np.where(alive, np.einsum("km,km->k", a, a) / inverse.diagonal(), np.inf)
        k = int(cost.argmin())
        alive[k] = False
        column = inverse[:, k] / inverse[k, k]
        a -= column[:, None] * a[k]
        dger(-1.0, column, inverse[k].copy(), a=inverse, overwrite_a=True)  # in place: large
        inverse[k, k] = 1.0  # out of the game
    return kept[alive]
