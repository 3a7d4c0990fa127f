"""Support vector regression, one machine per output (section III of the paper, Fig. 8)."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike
from sklearn.svm import SVR

from silpose.core.errors import InputError
from silpose.core.parallel import parallel_map
from silpose.core.parameters import NOT_NEGATIVE, POSITIVE, Constraints, check_parameters
from silpose.core.types import Array
from silpose.regression.basis import Basis
from silpose.regression.examples import ArrayExamples, TrainingExamples
from silpose.regression.linear_support_vectors import train_linear
from silpose.regression.regressor import Regressor
from silpose.regression.scales import scales_of, units_of

Problem = tuple[Array, float]
"""Values of one output (n,), and the half width of its tube."""

Machine = tuple[Array, float]
"""Weights of the examples (n,), and the offset."""


class SupportVectorRegressor(Regressor):
    """ε-insensitive regression on a basis, by scikit-learn's `SVR` where there are kernels.

    With kernels, the machines work on the examples that carry one. With a linear basis they work
    on all, and are solved for the features' weights where these are fewer.
    `joblib.parallel_config` sets how many machines are trained at the same time.

    Parameters
    ----------
    basis : Basis or None, default=None
        Kernels or features, not both, not fitted; None is `Basis()`.
    tube : float, default=1.0
        Half width ε of the tube within which errors cost nothing, in `units`.
    penalty : float, default=3.0
        C, for outputs of unit variance.
    units : array-like, shape (m,), or number or None, default=None
        One unit of error in each output, or one for all; None is 1.

    See Also
    --------
    RelevanceVectorRegressor : One sparse set of basis functions for all outputs.
    """

    constraints: ClassVar[Constraints] = {"tube": NOT_NEGATIVE, "penalty": POSITIVE}

    def __init__(
        self,
        basis: Basis | None = None,
        *,
        tube: float = 1.0,
        penalty: float = 3.0,
        units: ArrayLike | None = None,
    ) -> None:
        self.basis = basis
        self.tube = tube
        self.penalty = penalty
        self.units = units

    def fit_basis(self, basis: Basis, examples: TrainingExamples) -> None:
        """Train one machine per output on a fitted basis."""
        check_parameters(self)
        if not isinstance(examples, ArrayExamples):
            raise InputError(
                "a support vector machine needs all examples in memory: use `fit`, or fit a "
                "RidgeRegressor or RelevanceVectorRegressor to blocks"
            )
        z, x = examples.z, examples.x
        if basis.kernel and basis.linear:
            raise InputError("support vectors need kernels or a linear basis, not both")
        f = basis.evaluate(z)
        rows = basis.indices_ if basis.kernel else np.arange(len(z))
        mean, scale, varies = scales_of(x)
        moving = np.flatnonzero(varies)
        tubes = self.tube * units_of(self.units, len(mean))
        machines = parallel_map(
            self._trainer(f[rows] if basis.kernel else f, bool(basis.kernel)),
            [((x[rows, j] - mean[j]) / scale[j], tubes[j] / scale[j]) for j in moving],
            prefer="threads",  # all work is done outside of Python's lock
        )
        dual = np.zeros((len(rows), x.shape[1]))
        self.intercept_ = mean.copy()
        for j, (weights, offset) in zip(moving, machines, strict=True):
            dual[:, j] = weights * scale[j]
            self.intercept_[j] += offset * scale[j]
        support = np.flatnonzero(dual.any(axis=1))
        if basis.kernel:
            self.weights_ = dual[support]
            self._keep_basis(basis, support)
        else:
            self.weights_ = f.T @ dual
            self._keep_basis(basis, np.arange(basis.size_))
        self.kept_ = len(support) / len(rows)
        self.kept_per_output_ = np.count_nonzero(dual) / dual.size

    def _trainer(self, f: Array, kernels: bool) -> Callable[[Problem], Machine]:
        """Return what trains the machine of one output, from kernels or from features (n, k)."""
        if kernels or f.shape[1] > len(f):
            return partial(_train_on_kernels, f if kernels else f @ f.T, self.penalty)
        return lambda problem: train_linear(f, problem[0], self.penalty, problem[1])


def _train_on_kernels(gram: Array, penalty: float, problem: Problem) -> Machine:
    y, tube = problem
    machine = SVR(kernel="precomputed", C=penalty, epsilon=tube).fit(gram, y)
    weights = np.zeros(len(y))
    weights[machine.support_] = machine.dual_coef_[0]
    return weights, float(machine.intercept_[0])
