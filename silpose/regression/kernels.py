"""Kernel functions of a basis, and the scale of each."""

from __future__ import annotations

import numpy as np
from sklearn.metrics import pairwise

from silpose.core.types import Array, Indices

KERNELS = ("gaussian", "laplacian", "chi2", "polynomial", "sigmoid", "cosine")
OTHER_KERNELS = tuple(sorted({*pairwise.PAIRWISE_KERNEL_FUNCTIONS} - {*KERNELS}))
_GAUSSIAN = ("gaussian", "rbf")
_SAMPLE = 500  # examples from whose pairs the typical distance of other kernels is taken


def kernel_values(inputs: Array, centres: Array, kernel: str, beta: float) -> Array:
    """Evaluate the kernels at centres (k, d) for inputs (n, d), shape (n, k)."""
    if kernel in _GAUSSIAN:
        exponents = gaussian_exponents(inputs, centres, beta)
        return np.exp(exponents, out=exponents)
    # One job, as more would round differently.
    values = pairwise.pairwise_kernels(
        inputs, centres, kernel, n_jobs=1, filter_params=True, gamma=beta
    )
    return np.asarray(values)


def gaussian_exponents(inputs: Array, centres: Array, beta: float) -> Array:
    """-β ‖z - z_k‖², shape (n, k), by scikit-learn's arithmetic, without its checks."""
    squared = inputs @ centres.T
    squared *= -2
    squared += np.einsum("ij,ij->i", inputs, inputs)[:, None]
    squared += np.einsum("ij,ij->i", centres, centres)
    np.maximum(squared, 0, out=squared)
    return np.multiply(squared, -beta, out=squared)


def sampled_rows(count: int) -> Indices:
    """Return the rows of so many examples from which the typical distance is taken."""
    return np.arange(0, count, max(1, count // _SAMPLE))


def typical_distance(kernel: str, mean: Array, variance: Array, sample: Array) -> float:
    """Distance of two inputs, as the kernel measures it, on average.

    Parameters
    ----------
    kernel : str
    mean, variance : ndarray, shape (d,)
        Of all inputs.
    sample : ndarray, shape (n, d)
        Inputs at `sampled_rows`.
    """
    if kernel in _GAUSSIAN:
        return float(2 * variance.sum())
    if kernel == "laplacian":
        return float(pairwise.manhattan_distances(sample).mean())
    if kernel == "chi2":
        return float(-pairwise.additive_chi2_kernel(sample).mean())
    return float((variance + mean**2).sum())
