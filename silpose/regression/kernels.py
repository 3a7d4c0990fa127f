"""Kernel functions of a basis, and the scale of each."""

from __future__ import annotations

import numpy as np
from sklearn.metrics import pairwise

from silpose.core.types import Array

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


def typical_distance(inputs: Array, kernel: str) -> float:
    """Distance of two inputs, as the kernel measures it, on average."""
    if kernel in _GAUSSIAN:
        return float(2 * inputs.var(axis=0).sum())
    some = inputs[:: max(1, len(inputs) // _SAMPLE)]
    if kernel == "laplacian":
        return float(pairwise.manhattan_distances(some).mean())
    if kernel == "chi2":
        return float(-pairwise.additive_chi2_kernel(some).mean())
    return float((inputs**2).sum(axis=1).mean())
