"""Ridge regression: Eq. 4."""

from __future__ import annotations

from typing import ClassVar, Literal

import numpy as np

from silpose.core.parameters import POSITIVE, Constraints, check_parameters
from silpose.regression.basis import Basis
from silpose.regression.examples import TrainingExamples
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.regressor import Regressor

_USUAL = 0.1  # damping where no examples are at hand to choose by


class RidgeRegressor(Regressor):
    """Damped least squares: min ‖A F - Y‖² + λ ‖A‖² (Eq. 4), its offset undamped.

    The penalty is the equation's; the paper's augmented matrix (F λI) would give λ² ‖A‖².

    Parameters
    ----------
    basis : Basis or None, default=None
        Basis functions, not fitted; None is `Basis()`.
    damping : float or "auto", default="auto"
        λ; outputs are scaled to unit variance first. "auto" is the one whose leave-one-out error
        is least; where only normal equations are known, in `fit_system`, it is 0.1.

    Attributes
    ----------
    damping_ : float
        The λ that was used.

    See Also
    --------
    RelevanceVectorRegressor : Keeps few of the basis functions.
    """

    constraints: ClassVar[Constraints] = {"damping": POSITIVE.or_word("auto")}

    def __init__(
        self, basis: Basis | None = None, *, damping: float | Literal["auto"] = "auto"
    ) -> None:
        self.basis = basis
        self.damping = damping

    def _fit_chosen(self, basis: Basis, examples: TrainingExamples) -> None:
        if self.damping != "auto":
            super()._fit_chosen(basis, examples)
            return
        chosen = examples.choose(basis)
        fitted = examples.fit(chosen.basis)
        self._solve(fitted, examples.equations(fitted), chosen.damping)

    def fit_system(self, basis: Basis, system: NormalEquations) -> None:
        """Solve normal equations that are known already."""
        check_parameters(self)
        self._solve(basis, system, _USUAL if self.damping == "auto" else float(self.damping))

    def _solve(self, basis: Basis, system: NormalEquations, damping: float) -> None:
        self.damping_ = damping
        every = np.arange(basis.size_)
        self._keep(basis, system, system.solve(damping), every, np.full(basis.size_, damping))
