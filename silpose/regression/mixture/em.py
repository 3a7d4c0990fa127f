"""Expectation maximisation of a mixture's components, over examples in memory or in blocks."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Array
from silpose.regression.mixture.expert_sums import ExpertSums
from silpose.regression.mixture.experts import Experts, Prior


@dataclass(frozen=True)
class Expectation:
    """What the E-step finds.

    Attributes
    ----------
    size : ndarray, shape (K,)
        Sum of each component's responsibilities.
    log_likelihood : float
        Of all examples.
    sums : callable
        From the components that are kept, bool (K,), to the sums that their M-step needs.
    """

    size: Array
    log_likelihood: float
    sums: Callable[[NDArray[np.bool_]], ExpertSums]


class ReducedExamples(Protocol):
    """Examples (ψ, x) of a mixture."""

    @property
    def count(self) -> int:
        """Number of examples."""

    def expect(self, experts: Experts) -> Expectation:
        """Compute the responsibilities: the E-step."""


def expectation_maximisation(
    examples: ReducedExamples,
    experts: Experts,
    prior: Prior,
    smallest: float,
    max_iter: int,
    tol: float,
) -> tuple[Experts, list[float], list[int]]:
    """Fit components.

    Parameters
    ----------
    examples : ReducedExamples
    experts : Experts
        Where to start.
    prior : Prior
    smallest : float
        Components with fewer examples, as a sum of responsibilities, are pruned.
    max_iter : int
        Largest number of rounds.
    tol : float
        Converged once a round adds less than this to the objective, and none is to be pruned.

    Returns
    -------
    experts : Experts
    objective : list of float
        Penalised log-likelihood per example, before each round.
    pruned : list of int
        Rounds before which components were pruned; only there may the objective fall.
    """
    objective: list[float] = []
    pruned: list[int] = []
    for _ in range(max_iter):
        found = examples.expect(experts)
        reached = (found.log_likelihood - experts.penalty(prior)) / examples.count
        settled = len(objective) > 0 and abs(reached - objective[-1]) < tol
        objective.append(reached)
        large = found.size >= min(smallest, found.size.max())
        if settled and large.all():
            break
        if not large.all():
            pruned.append(len(objective))
        experts = Experts.of(found.sums(large), prior)
    return experts, objective, pruned
