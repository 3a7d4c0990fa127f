"""Log-likelihoods of poses by several densities that share their components.

That is what choosing parameters of prediction takes: the components' means, and all else that only
some of the parameters matter for, are computed once for a few inputs at a time.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Array
from silpose.regression.mixture.density import ConditionalDensity, MixtureInput, log_total


def log_likelihoods(
    densities: Sequence[ConditionalDensity],
    inputs: MixtureInput,
    x: Array,
    columns: NDArray[np.bool_],
) -> Array:
    """Log p(x|ψ) of some columns of standardised poses.

    Parameters
    ----------
    densities : sequence of ConditionalDensity
        That differ in parameters of `MixtureOfRegressors` only.
    inputs : MixtureInput
    x : ndarray, shape (n, D)
    columns : ndarray of bool, shape (D,)

    Returns
    -------
    log_likelihoods : ndarray, shape (S, n)
        A row for each density.
    """
    found, start = np.empty((len(densities), len(x))), 0
    for some in inputs.blocks():
        rows = slice(start, start + len(some.psi))
        likelihoods = _Likelihoods(some, x[rows], columns)
        for own, density in zip(found, densities, strict=True):
            own[rows] = likelihoods.under(density)
        start = rows.stop
    return found


class _Likelihoods:
    """Log-likelihoods of a few poses."""

    def __init__(self, inputs: MixtureInput, x: Array, columns: NDArray[np.bool_]) -> None:
        self._inputs, self._x, self._columns = inputs, x, columns
        self._known: dict[tuple[object, ...], Array] = {}
        self._moved: dict[float, tuple[Array | None, Array]] = {}

    def under(self, density: ConditionalDensity) -> Array:
        """Log p(x|ψ), shape (n,)."""
        gates = self._once(
            lambda: density.log_gates(self._inputs),
            *("gates", density.temperature, density.outlier_probability),
        )
        misfits = self._once(
            lambda: self._misfits(density),
            *("misfits", density.noise_width, density.shared_width, density.floor),
        )
        evidence, _ = self._means(density)
        weights = density.log_weights(gates[:, :-1], gates[:, -1:], evidence)
        return log_total(weights - 0.5 * misfits)[:, 0]

    def _misfits(self, density: ConditionalDensity) -> Array:
        """Minus twice the log density of each component and the background, (n, K + 1)."""
        _, means = self._means(density)
        variances = density.variances()
        precisions = np.where(self._columns, 1 / variances, 0)
        constant = np.log(2 * np.pi * variances[:, self._columns]).sum(axis=1)
        off = means - self._x[:, None]
        own = np.einsum("nkd,nkd,kd->nk", off, off, precisions[:-1])
        return np.column_stack([own, self._x**2 @ precisions[-1]]) + constant

    def _means(self, density: ConditionalDensity) -> tuple[Array | None, Array]:
        """Return the components' means, moved towards the shared regressor's, and its evidence."""
        every = np.arange(len(density.experts.offsets))
        means = self._once(lambda: density.experts.means(self._inputs.psi, every), "means")
        if density.shared_width not in self._moved:
            self._moved[density.shared_width] = density.moved(self._inputs, means, every)
        return self._moved[density.shared_width]

    def _once(self, compute: Callable[[], Array], *key: object) -> Array:
        if key not in self._known:
            self._known[key] = compute()
        return self._known[key]
