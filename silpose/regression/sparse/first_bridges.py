"""Continuations that begin at ridge regression, shared by all RVMs of one problem.

Several RVMs of the same normal equations, such as those of different sparsity, begin with the same
ν's, whose first iterations, on all columns, cost most.
"""

from __future__ import annotations

from silpose.core.once import Once
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.sparse.quadratic_bridges import Bridges, minimise_with_bridges


class FirstBridges:
    """Ridge regression, and where continuations from it end; each is computed once.

    Threads may ask at the same time: the second to ask for the same waits for the first.

    Parameters
    ----------
    system : NormalEquations

    Attributes
    ----------
    system : NormalEquations
    """

    def __init__(self, system: NormalEquations) -> None:
        self.system = system
        self._found: Once[Bridges] = Once()

    @property
    def start(self) -> Bridges:
        """Ridge regression: step 1 of Fig. 4."""
        return self._found.get((), lambda: Bridges.start(self.system))

    def end(self, nu: float, max_iter: int, tol: float) -> Bridges:
        """Minimise Eq. 5 from there; parameters are those of `minimise_with_bridges`."""
        return self._found.get(
            (nu, max_iter, tol),
            lambda: minimise_with_bridges(self.system, self.start, nu, max_iter, tol),
        )
