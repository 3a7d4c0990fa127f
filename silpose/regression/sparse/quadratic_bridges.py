"""Quadratic bridges: the continuation that minimises Eq. 5 (Figs. 4 and 5)."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from sklearn.exceptions import ConvergenceWarning

from silpose.core.types import Array, Indices
from silpose.regression.normal_equations import NormalEquations, solve_damped

START_DAMPING = 0.01  # of the ridge regression that starts the continuation
_ZERO = 1e-2  # share of the largest column's norm below which a column counts as zero
_TINY = 1e-150  # its square is still above 0


@dataclass
class Bridges:
    """State of the continuation: the columns not yet removed, and their coefficients.

    Attributes
    ----------
    kept : ndarray of int, shape (k,)
        Basis functions whose column a_k is not zero.
    a : ndarray, shape (k, m)
        The columns, as rows.
    damping : ndarray, shape (k,)
        Damping of each column in the last minimisation: ν / 2 s_k².
    history : list of (int, float), default=[]
        Number of columns and value of Eq. 5 after every iteration.
    """

    kept: Indices
    a: Array
    damping: Array
    history: list[tuple[int, float]] = field(default_factory=list)

    @classmethod
    def start(cls, system: NormalEquations) -> Bridges:
        """Step 1 of Fig. 4: ridge regression."""
        size = len(system.gram)
        return cls(np.arange(size), system.solve(START_DAMPING), np.full(size, START_DAMPING))


def minimise_with_bridges(
    system: NormalEquations,
    start: Bridges,
    nu: float,
    max_iter: int,
    tol: float,
    watch: Callable[[Indices, Array], None] = lambda kept, norms: None,
) -> Bridges:
    """Minimise ‖F A - Y‖² + ν Σ_k log ‖a_k‖ (Eq. 5) from a start: steps 2 to 4 of Fig. 4.

    The bridge ν/2 (‖a_k‖ / s_k)² touches the penalty at s_k = ‖a_k‖ from above, so each
    minimisation lowers the objective: (FᵀF + ν/2 S⁻²) A = FᵀY, S = diag(s). As columns go to zero
    that looks ill-conditioned, and is not: Cholesky's factor is as accurate as that of
    S FᵀF S + ν/2 I (J. Demmel, "On floating point errors in Cholesky", 1989).

    Parameters
    ----------
    system : NormalEquations
    start : Bridges
    nu : float
        ν.
    max_iter : int
        Number of iterations after which a ConvergenceWarning is issued.
    tol : float
        Converged once an iteration changes the coefficients by less than this share.
    watch : callable, optional
        Called after every iteration with the columns kept and their norms.

    Returns
    -------
    end : Bridges
    """
    kept, a, damping = start.kept, start.a, start.damping
    scale = np.linalg.norm(a, axis=1)
    history: list[tuple[int, float]] = []
    target = system.target[kept]
    for _ in range(max_iter):
        alive = np.flatnonzero(scale > _ZERO * scale.max(initial=0.0))
        if len(alive) < len(kept):
            kept, a, scale, target = kept[alive], a[alive], scale[alive], target[alive]
            damping = damping[alive]
        if not len(kept):
            break
        damping = nu / (2 * np.maximum(scale, _TINY) ** 2)
        before, a = a, solve_damped(system.gram_among(kept), target, damping)
        scale = np.linalg.norm(a, axis=1)
        # ‖F A - Y‖², where FᵀF A is known from the equations just solved.
        error = system.power.sum() - np.sum(a * target) - np.sum(damping[:, None] * a**2)
        with np.errstate(divide="ignore"):
            history.append((len(kept), float(error + nu * np.log(scale).sum())))
        watch(kept, scale)
        # Not by `norm`, whose threads keep a processor busy that LAPACK's would use next.
        change = np.sqrt(np.square(a - before).sum() / np.square(before).sum())
        if change < tol:
            break
    else:
        warnings.warn(
            f"the coefficients still change by {change:.1g} after {max_iter} iterations at "
            f"nu={nu:.3g}: raise max_iter or tol",
            ConvergenceWarning,
            stacklevel=2,
        )
    return Bridges(kept, a, damping, history)
