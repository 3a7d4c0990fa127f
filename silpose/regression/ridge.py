"""Ridge regression: Eq. 4."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from silpose.core.parameters import POSITIVE, Constraints, check_parameters
from silpose.regression.basis import Basis
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.regressor import Regressor


class RidgeRegressor(Regressor):
    """Damped least squares: min ‖A F - Y‖² + λ ‖A‖² (Eq. 4), its offset undamped.

    The penalty is the equation's; the paper's augmented matrix (F λI) would give λ² ‖A‖².

    Parameters
    ----------
    basis : Basis or None, default=None
        Basis functions, not fitted; None is `Basis()`.
    damping : float, default=0.1
        λ; outputs are scaled to unit variance first.

    See Also
    --------
    RelevanceVectorRegressor : Keeps few of the basis functions.
    """

    constraints: ClassVar[Constraints] = {"damping": POSITIVE}

    def __init__(self, basis: Basis | None = None, *, damping: float = 0.1) -> None:
        self.basis = basis
        self.damping = damping

    def fit_system(self, basis: Basis, system: NormalEquations) -> None:
        """Solve normal equations that are known already."""
        check_parameters(self)
        everything = np.arange(basis.size_)
        damping = np.full(basis.size_, float(self.damping))
        self._keep(basis, system, system.solve(self.damping), everything, damping)
