"""The relevance vector machine by quadratic bridges: Eq. 5 and Fig. 4."""

from __future__ import annotations

import warnings

import numpy as np
from numpy.typing import NDArray
from sklearn.exceptions import ConvergenceWarning

from silpose.core.errors import InputError
from silpose.regression.basis import Basis
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.regressor import Regressor
from silpose.regression.sparse.elimination import sparsest_within
from silpose.regression.sparse.quadratic_bridges import Bridges, minimise_with_bridges

Array = NDArray[np.float64]

PRIORS = ("column", "component")


class RelevanceVectorRegressor(Regressor):
    """Sparse regression whose outputs share one set of relevance vectors (Eq. 5, Fig. 4).

    Minimises ‖A F - Y‖² + ν R(A), outputs scaled to unit variance, the offset undamped.

    Parameters
    ----------
    basis : Basis or None
        None is the default basis.
    prior : {"column", "component"}
        R(A) = Σ_k log ‖a_k‖, which selects basis functions for all outputs at once, or
        R(A) = Σ_jk log |A_jk|, which selects for each output on its own.
    nu : float
        ν: the larger, the sparser. With `keep_at_most`, where the path begins.
    keep_at_most : float or None
        Share of the basis functions to keep: ν is chosen to keep somewhat more, and the rest
        is removed by backward elimination.
    max_iter : int
        For each ν.
    tol : float
        Converged once an iteration changes the coefficients by less than this share.

    Attributes
    ----------
    nu_ : float
        The ν that was used last.
    n_iter_ : int
        At that ν; with componentwise priors, the most that an output took.
    history_ : ndarray, shape (n_iter_, 2)
        After every iteration at `nu_`: number of columns and value of Eq. 5. Empty with
        componentwise priors.
    """

    def __init__(
        self,
        basis: Basis | None = None,
        prior: str = "column",
        nu: float = 8.0,
        keep_at_most: float | None = None,
        max_iter: int = 200,
        tol: float = 1e-2,
    ) -> None:
        self.basis = basis
        self.prior = prior
        self.nu = nu
        self.keep_at_most = keep_at_most
        self.max_iter = max_iter
        self.tol = tol

    def fit_system(self, basis: Basis, system: NormalEquations) -> None:
        """Minimise Eq. 5 for normal equations already at hand."""
        if self.nu <= 0:
            raise InputError(f"nu must be positive, not {self.nu}")
        if self.prior not in PRIORS:
            raise InputError(f"prior is 'column' or 'component', not '{self.prior}'")
        if self.keep_at_most is None:
            fit = self._columns if self.prior == "column" else self._components
            self.use_fitted(basis, system, self.nu, fit(system))
            if not len(self.relevance_):
                warnings.warn(
                    f"nu={self.nu:.3g} removes all basis functions: the mean is predicted",
                    ConvergenceWarning,
                    stacklevel=3,
                )
            return
        if not 0 < self.keep_at_most <= 1:
            raise InputError(f"keep_at_most is a share up to 1, not {self.keep_at_most}")
        if self.prior != "column":
            raise InputError("keep_at_most wants prior='column': one set of relevance vectors")
        count = max(1, int(self.keep_at_most * basis.size_))
        start = Bridges.start(system)
        nu, end = sparsest_within(system, count, self.nu, start, self.max_iter, self.tol)
        self.use_fitted(basis, system, nu, end)

    def _columns(self, system: NormalEquations) -> Bridges:
        return minimise_with_bridges(
            system, Bridges.start(system), self.nu, self.max_iter, self.tol
        )

    def _components(self, system: NormalEquations) -> Bridges:
        """Solve for each output, and put what they keep together."""
        start = Bridges.start(system).a
        size, outputs = start.shape
        a, damping = np.zeros((size, outputs)), np.full((size, outputs), np.inf)
        steps: list[tuple[int, float]] = []
        for j in range(outputs):
            ridge = Bridges(np.arange(size), start[:, [j]], np.zeros(size))
            end = minimise_with_bridges(system.output(j), ridge, self.nu, self.max_iter, self.tol)
            a[end.kept, j], damping[end.kept, j] = end.a[:, 0], end.damping
            steps = max(steps, end.history, key=len)
        kept = np.flatnonzero(a.any(axis=1))
        # For the predictive variance, which all outputs share, the weakest damping of each column.
        history = [(len(kept), np.nan)] * len(steps)
        return Bridges(kept, a[kept], damping[kept].min(axis=1, initial=np.inf), history)

    def use_fitted(self, basis: Basis, system: NormalEquations, nu: float, end: Bridges) -> None:
        """Become the regressor at the end of a path."""
        self.nu_ = nu
        self.history_ = np.array(end.history, dtype=float).reshape(-1, 2)
        self.n_iter_ = max(1, len(end.history))
        self._keep(basis, system, end.a, end.kept, end.damping)
