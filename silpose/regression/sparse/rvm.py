"""The relevance vector machine by quadratic bridges: Eq. 5 and Fig. 4."""

from __future__ import annotations

import warnings
from typing import ClassVar, Literal

import numpy as np
from sklearn.exceptions import ConvergenceWarning

from silpose.core.errors import InputError
from silpose.core.parameters import (
    NOT_NEGATIVE,
    POSITIVE,
    POSITIVE_INTEGER,
    SHARE,
    Constraints,
    check_parameters,
    one_of,
)
from silpose.regression.basis import Basis
from silpose.regression.examples import TrainingExamples
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.regressor import Regressor
from silpose.regression.sparse.elimination import sparsest_within
from silpose.regression.sparse.first_bridges import FirstBridges
from silpose.regression.sparse.quadratic_bridges import Bridges, minimise_with_bridges

_USUAL = 8.0  # ν where no examples are at hand to choose by
_SHARE = 0.25  # ν over the sum of outputs' noise: their errors go together
_LEAST = 1e-6  # ν of outputs without noise


class RelevanceVectorRegressor(Regressor):
    """Sparse regression whose outputs share one set of relevance vectors (Eq. 5, Fig. 4).

    Minimises ‖A F - Y‖² + ν R(A), outputs scaled to unit variance, the offset undamped.

    Parameters
    ----------
    basis : Basis or None, default=None
        Basis functions, not fitted; None is `Basis()`.
    prior : {"column", "component"}, default="column"
        R(A) = Σ_k log ‖a_k‖, which selects basis functions for all outputs at once, or
        R(A) = Σ_jk log |A_jk|, which selects for each output on its own.
    nu : float or "auto", default="auto"
        ν: the larger, the sparser. With `keep_at_most`, where the path begins. "auto" is a share
        of the noise that ridge regression leaves when examples are left out one at a time; where
        only normal equations are known, in `fit_system`, it is 8.
    keep_at_most : float or None, default=None
        Share of the basis functions to keep: ν is chosen to keep somewhat more, and the rest
        is removed by backward elimination.
    max_iter : int, default=200
        Iterations at each ν.
    tol : float, default=1e-2
        Converged once an iteration changes the coefficients by less than this share.

    Attributes
    ----------
    nu_ : float
        The ν that was used last.
    n_iter_ : int
        Iterations at that ν; with componentwise priors, the most of any output.
    history_ : ndarray, shape (n_iter_, 2)
        Number of columns and value of Eq. 5 after every iteration at `nu_`; with componentwise
        priors the value is NaN.

    See Also
    --------
    RidgeRegressor : Keeps all basis functions.
    follow_bridges : Norms of all columns at every iteration.
    """

    constraints: ClassVar[Constraints] = {
        "prior": one_of("column", "component"),
        "nu": POSITIVE.or_word("auto"),
        "keep_at_most": SHARE.or_none(),
        "max_iter": POSITIVE_INTEGER,
        "tol": NOT_NEGATIVE,
    }

    def __init__(
        self,
        basis: Basis | None = None,
        *,
        prior: Literal["column", "component"] = "column",
        nu: float | Literal["auto"] = "auto",
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
        """Minimise Eq. 5 for normal equations that are known already."""
        self.fit_from(basis, FirstBridges(system))

    def fit_from(self, basis: Basis, first: FirstBridges) -> None:
        """Minimise Eq. 5 by continuations that other RVMs of the same problem may have begun.

        Parameters
        ----------
        basis : Basis
            Fitted.
        first : FirstBridges
        """
        check_parameters(self)
        self._minimise(basis, first, self.first_nu)

    @property
    def first_nu(self) -> float:
        """`nu`, or the usual one where it is "auto" and no examples are at hand to choose by."""
        return _USUAL if self.nu == "auto" else float(self.nu)

    def _fit_chosen(self, basis: Basis, examples: TrainingExamples) -> None:
        if self.nu != "auto":
            super()._fit_chosen(basis, examples)
            return
        chosen = examples.choose(basis)
        fitted = examples.fit(chosen.basis)
        nu = max(_SHARE * float(chosen.noise.sum()), _LEAST)
        self._minimise(fitted, FirstBridges(examples.equations(fitted)), nu)

    def _minimise(self, basis: Basis, first: FirstBridges, nu: float) -> None:
        limits = self.max_iter, self.tol
        if self.keep_at_most is not None:
            if self.prior != "column":
                raise InputError("keep_at_most needs prior='column': one set of relevance vectors")
            count = max(1, int(self.keep_at_most * basis.size_))
            found = sparsest_within(first, count, nu, *limits)
            self.use_fitted(basis, first.system, *found)
            return
        by_column = self.prior == "column"
        end = first.end(nu, *limits) if by_column else self._components(first, nu)
        self.use_fitted(basis, first.system, nu, end)
        if not len(self.relevance_):
            warnings.warn(
                f"nu={nu:.3g} removes all basis functions: the mean is predicted",
                ConvergenceWarning,
                stacklevel=3,
            )

    def _components(self, first: FirstBridges, nu: float) -> Bridges:
        """Minimise for each output, and unite the columns that any of them keeps."""
        system, start = first.system, first.start
        size, outputs = start.a.shape
        a, damping = np.zeros((size, outputs)), np.full((size, outputs), np.inf)
        steps: list[tuple[int, float]] = []
        for j in range(outputs):
            ridge = Bridges(np.arange(size), start.a[:, [j]], np.zeros(size))
            end = minimise_with_bridges(system.output(j), ridge, nu, self.max_iter, self.tol)
            a[end.kept, j], damping[end.kept, j] = end.a[:, 0], end.damping
            steps = max(steps, end.history, key=len)
        kept = np.flatnonzero(a.any(axis=1))
        # For the predictive variance, which all outputs share, the weakest damping of each column.
        history = [(len(kept), np.nan)] * len(steps)
        return Bridges(kept, a[kept], damping[kept].min(axis=1, initial=np.inf), history)

    def use_fitted(self, basis: Basis, system: NormalEquations, nu: float, end: Bridges) -> None:
        """Use a solution that is known already, such as one on a path over several ν.

        Parameters
        ----------
        basis : Basis
            Fitted.
        system : NormalEquations
            Of its functions.
        nu : float
            The ν of the solution.
        end : Bridges
        """
        self.nu_ = nu
        self.history_ = np.array(end.history, dtype=float).reshape(-1, 2)
        self.n_iter_ = max(1, len(end.history))
        self._keep(basis, system, end.a, end.kept, end.damping)
