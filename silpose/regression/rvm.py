"""The relevance vector machine by quadratic bridges: Eq. 5 and Fig. 4."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from sklearn.exceptions import ConvergenceWarning

from silpose.errors import InputError
from silpose.regression.basis import GaussianBasis
from silpose.regression.normal_equations import NormalEquations, solve_damped
from silpose.regression.regressor import Regressor

Array = NDArray[np.float64]

_ZERO = 1e-3  # a column counts as zero below this share of the largest column's norm
_START_DAMPING = 0.01  # of the ridge regression that starts the continuation
_STEP = 2.0  # factor between the ν's of the path to a wanted sparsity
_WEAKER = 40  # weaker ν's tried at most where the first one removes too much
_HALVINGS = 5  # of the last step, to come near the wanted sparsity


@dataclass
class Bridges:
    """State of the continuation: the columns not yet removed, and their coefficients.

    Attributes
    ----------
    kept : ndarray of int, shape (k,)
        Basis functions whose column a_k is not zero.
    a : ndarray, shape (k, m)
        The columns, as rows.
    objective : list of (int, float)
        After every iteration: number of columns and value of Eq. 5.
    """

    kept: NDArray[np.intp]
    a: Array
    objective: list[tuple[int, float]] = field(default_factory=list)

    @classmethod
    def start(cls, system: NormalEquations) -> Bridges:
        """Step 1 of Fig. 4: a ridge regression."""
        return cls(np.arange(len(system.gram)), system.solve(_START_DAMPING))


def cross(system: NormalEquations, start: Bridges, nu: float, max_iter: int, tol: float) -> Bridges:
    """Minimise ‖F A - Y‖² + ν Σ_k log ‖a_k‖ from a start: steps 2 to 4 of Fig. 4.

    The bridge ν/2 (‖a_k‖ / s_k)² touches the penalty at s_k = ‖a_k‖ from above, so each
    minimisation lowers the objective. In the scaled unknowns B = S⁻¹A, S = diag(s), the step
    reads (S FᵀF S + ν/2 I) B = S FᵀY, which stays well conditioned as columns go to zero.

    Parameters
    ----------
    system : NormalEquations
    start : Bridges
    nu : float
        ν.
    max_iter : int
    tol : float
        Converged once an iteration changes the coefficients by less than this share.

    Returns
    -------
    end : Bridges
    """
    kept, a = start.kept, start.a
    scale = np.linalg.norm(a, axis=1)
    objective: list[tuple[int, float]] = []
    gram, target = system.gram[np.ix_(kept, kept)], system.target[kept]
    for _ in range(max_iter):
        alive = scale > _ZERO * scale.max(initial=0.0)
        if not alive.all():
            kept, a, scale, target = kept[alive], a[alive], scale[alive], target[alive]
            gram = gram[np.ix_(alive, alive)]
        if not len(kept):
            break
        bridged = gram * scale * scale[:, None]
        before, a = a, scale[:, None] * solve_damped(bridged, scale[:, None] * target, nu / 2)
        scale = np.linalg.norm(a, axis=1)
        fit = system.residue - 2 * np.sum(a * target) + np.sum(a * (gram @ a))
        with np.errstate(divide="ignore"):
            objective.append((len(kept), float(fit + nu * np.log(scale).sum())))
        change = np.linalg.norm(a - before) / np.linalg.norm(before)
        if change < tol:
            break
    else:
        warnings.warn(
            f"the coefficients still change by {change:.1g} after {max_iter} iterations at "
            f"nu={nu:.3g}: raise max_iter or tol",
            ConvergenceWarning,
            stacklevel=2,
        )
    return Bridges(kept, a, objective)


def sparsest_within(
    system: NormalEquations, count: int, nu: float, start: Bridges, max_iter: int, tol: float
) -> tuple[float, Bridges]:
    """Find a ν that keeps at most `count` columns, and comes as near to that as possible.

    Each ν starts from the end of the one before: a path along decreasing density, on which
    columns leave one after the other, and which ends in better minima than a start from ridge.

    Parameters
    ----------
    system : NormalEquations
    count : int
    nu : float
        First ν of the path.
    start : Bridges
        Where it begins.
    max_iter, tol
        As for `cross`.

    Returns
    -------
    nu : float
    end : Bridges
    """
    sparse = cross(system, start, nu, max_iter, tol)
    low, dense = nu, start
    for _ in range(_WEAKER):  # the first ν may be too strong for a small problem
        if len(sparse.kept) >= min(count, len(start.kept)):
            break
        low = nu / _STEP
        state = cross(system, start, low, max_iter, tol)
        if len(state.kept) > count:
            dense = state
            break
        nu, sparse = low, state
    while len(sparse.kept) > count:
        low, dense, nu = nu, sparse, nu * _STEP
        sparse = cross(system, dense, nu, max_iter, tol)
    for _ in range(_HALVINGS):
        if len(sparse.kept) == count:
            break
        middle = float(np.sqrt(low * nu))
        state = cross(system, dense, middle, max_iter, tol)
        if len(state.kept) <= count:
            nu, sparse = middle, state
        else:
            low, dense = middle, state
    return nu, sparse


class RelevanceVectorRegressor(Regressor):
    """Sparse regression whose outputs share one set of relevance vectors (Eq. 5, Fig. 4).

    Minimises ‖A F - Y‖² + ν Σ_k log ‖a_k‖ over all outputs at once, outputs scaled to unit
    variance, the offset undamped.

    Parameters
    ----------
    basis : GaussianBasis or None
        None is the default basis.
    nu : float
        ν: the larger, the sparser. With `keep_at_most`, where to begin.
    keep_at_most : float or None
        Share of the basis functions to keep at most; ν is then raised until that holds.
    max_iter : int
        For each ν.
    tol : float
        Converged once an iteration changes the coefficients by less than this share.

    Attributes
    ----------
    nu_ : float
        The ν that was used last.
    n_iter_ : int
    objective_ : ndarray, shape (n_iter_,)
        Value of Eq. 5 after every iteration at `nu_`.
    """

    def __init__(
        self,
        basis: GaussianBasis | None = None,
        nu: float = 8.0,
        keep_at_most: float | None = None,
        max_iter: int = 200,
        tol: float = 1e-2,
    ) -> None:
        self.basis = basis
        self.nu = nu
        self.keep_at_most = keep_at_most
        self.max_iter = max_iter
        self.tol = tol

    def fit_system(self, basis: GaussianBasis, system: NormalEquations) -> None:
        """Minimise Eq. 5 for normal equations already at hand."""
        if self.nu <= 0:
            raise InputError(f"nu must be positive, not {self.nu}")
        if self.keep_at_most is None:
            end = cross(system, Bridges.start(system), self.nu, self.max_iter, self.tol)
            self.take(basis, system, self.nu, end)
            return
        if not 0 < self.keep_at_most <= 1:
            raise InputError(f"keep_at_most is a share up to 1, not {self.keep_at_most}")
        count = max(1, int(self.keep_at_most * len(system.gram)))
        start = Bridges.start(system)
        nu, end = sparsest_within(system, count, self.nu, start, self.max_iter, self.tol)
        self.take(basis, system, nu, end)

    def take(self, basis: GaussianBasis, system: NormalEquations, nu: float, end: Bridges) -> None:
        """Become the regressor at the end of a path."""
        if not len(end.kept):
            warnings.warn(
                f"nu={nu:.3g} removes all basis functions: the mean is predicted",
                ConvergenceWarning,
                stacklevel=3,
            )
        self.nu_ = nu
        self.objective_ = np.array([value for _, value in end.objective])
        self.n_iter_ = len(end.objective)
        self._keep(basis, system, end.a, end.kept)
