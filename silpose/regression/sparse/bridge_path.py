"""Every iteration of an RVM on its way to sparsity (Fig. 5)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from silpose.core.parameters import NOT_NEGATIVE, POSITIVE, POSITIVE_INTEGER, check_values
from silpose.core.types import Array, Indices
from silpose.regression.basis import Basis
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.sparse.quadratic_bridges import Bridges, minimise_with_bridges


@dataclass(frozen=True)
class BridgePath:
    """Results of T iterations of the continuation.

    Attributes
    ----------
    norms : ndarray, shape (T, p)
        ‖a_k‖ of every basis function, 0 once it is removed.
    objective : ndarray, shape (T,)
        Value of Eq. 5.
    """

    norms: Array
    objective: Array


def follow_bridges(
    basis: Basis, z: Array, x: Array, nu: float, *, max_iter: int = 200, tol: float = 1e-2
) -> BridgePath:
    """Fit an RVM as `RelevanceVectorRegressor` does, and keep every iteration.

    Parameters
    ----------
    basis : Basis
        Fitted here.
    z : ndarray, shape (n, d)
    x : ndarray, shape (n, m)
    nu : float
        ν of Eq. 5.
    max_iter : int, default=200
    tol : float, default=1e-2
        As for `RelevanceVectorRegressor`.

    Returns
    -------
    path : BridgePath

    Raises
    ------
    InputError
        If a parameter cannot be used.
    """
    check_values("nu", POSITIVE, nu)
    check_values("max_iter", POSITIVE_INTEGER, max_iter)
    check_values("tol", NOT_NEGATIVE, tol)
    system = NormalEquations.of(basis.fit(z).evaluate(z), x)
    norms: list[Array] = []

    def watch(kept: Indices, scale: Array) -> None:
        norms.append(np.zeros(basis.size_))
        norms[-1][kept] = scale

    end = minimise_with_bridges(system, Bridges.start(system), nu, max_iter, tol, watch)
    return BridgePath(np.array(norms), np.array([value for _, value in end.history]))
