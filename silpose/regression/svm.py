"""Support vector regression, one machine per output (section III of the paper, Fig. 8)."""

from __future__ import annotations

import numpy as np
from joblib import Parallel, delayed
from numpy.typing import NDArray
from sklearn.svm import SVR

from silpose.core.errors import InputError
from silpose.regression.basis import Basis
from silpose.regression.regressor import Regressor

Array = NDArray[np.float64]


class SupportVectorRegressor(Regressor):
    """ε-insensitive regression on a basis, by scikit-learn's `SVR`.

    With kernels, the machines work on the examples that carry one; with a linear basis on all.

    Parameters
    ----------
    basis : Basis or None
        Kernels or features, not both. None is the default basis.
    tube : float or sequence of float
        Half width ε of the tube within which errors cost nothing, in the units of the outputs;
        or one for each output.
    penalty : float
        C, for outputs of unit variance.
    n_jobs : int or None
        Machines that are trained at the same time.
    """

    def __init__(
        self,
        basis: Basis | None = None,
        tube: float | Array = 0.1,
        penalty: float = 3.0,
        n_jobs: int | None = None,
    ) -> None:
        self.basis = basis
        self.tube = tube
        self.penalty = penalty
        self.n_jobs = n_jobs

    def fit_basis(self, basis: Basis, z: Array, x: Array) -> None:
        """Train a machine per output."""
        if self.penalty <= 0 or np.min(self.tube) < 0:
            raise InputError("penalty must be positive and tube not negative")
        if basis.kernel and basis.linear:
            raise InputError("support vectors want kernels or a linear basis, not both")
        f = basis.transform(z)
        rows = basis.indices_ if basis.kernel else np.arange(len(z))
        gram = f[rows] if basis.kernel else f @ f.T
        mean, scale = x.mean(axis=0), x.std(axis=0)
        moving = np.flatnonzero(scale > 1e-10 * np.maximum(np.abs(mean), 1))
        tubes = np.broadcast_to(np.asarray(self.tube, dtype=float), mean.shape)
        machines = Parallel(n_jobs=self.n_jobs)(
            delayed(_train)(
                gram,
                (x[rows, j] - mean[j]) / scale[j],
                tubes[j] / scale[j],
                self.penalty,
            )
            for j in moving
        )
        dual = np.zeros((len(rows), x.shape[1]))
        self.intercept_ = mean.copy()
        for j, (weights, offset) in zip(moving, machines, strict=True):
            dual[:, j] = weights * scale[j]
            self.intercept_[j] += offset * scale[j]
        support = np.flatnonzero(dual.any(axis=1))
        if basis.kernel:
            self.coef_ = dual[support]
            self._keep_basis(basis, support)
        else:
            self.coef_ = f.T @ dual
            self._keep_basis(basis, np.arange(basis.size_))
        self.kept_ = len(support) / len(rows)
        self.kept_per_output_ = np.count_nonzero(dual) / dual.size


def _train(gram: Array, y: Array, tube: float, penalty: float) -> tuple[Array, float]:
    machine = SVR(kernel="precomputed", C=penalty, epsilon=tube).fit(gram, y)
    weights = np.zeros(len(y))
    weights[machine.support_] = machine.dual_coef_[0]
    return weights, float(machine.intercept_[0])
