"""Locally weighted regression of the pose on the key poses with most weight.

W. S. Cleveland, S. J. Devlin, "Locally weighted regression", J. Am. Stat. Assoc. 1988.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_array

from silpose.core.types import Array, Indices
from silpose.tracking.distances import FEW, kernel
from silpose.tracking.key_examples import KeyExamples, KeyPoseComparison

_BLOCK = 64  # frames whose examples are copied at a time
_MOST = 64  # examples of largest weight that are regressed on; more hardly matter, but cost
_NOTHING = 1e-6  # sum of weights that is left out of the mean of very many


def regress_locally(
    weights: Array, poses: Array, descriptors: Array, seen: Array, damping: float
) -> Array:
    """Estimate poses by ridge regression, linear in the descriptor, around weighted means.

    Parameters
    ----------
    weights : ndarray, shape (F, K)
        Weights of the examples in each frame, which sum to 1.
    poses, descriptors : ndarray, shapes (K, D) and (K, d)
        Examples.
    seen : ndarray, shape (F, d)
        Where to evaluate; with NaN, for nothing seen, the weighted mean is returned.
    damping : float
        λ of the squared slope: the larger, the nearer a pose stays to the weighted mean.

    Returns
    -------
    x : ndarray, shape (F, D)
    """
    kept: Array | csr_array = weights
    if weights.shape[1] > FEW:
        kept = csr_array(np.where(weights > _NOTHING / weights.shape[1], weights, 0))
    x, means = kept @ poses, kept @ descriptors
    frames = np.flatnonzero(~np.isnan(seen).any(axis=1))
    for start in range(0, len(frames), _BLOCK):
        own = frames[start : start + _BLOCK]
        some = _largest(weights[own])
        roots = np.sqrt(np.take_along_axis(weights[own], some, axis=1))[..., None]
        inputs = roots * (descriptors[some] - means[own, None])
        outputs = roots * (poses[some] - x[own, None])
        gram = inputs @ inputs.mT  # fewer examples than inputs: the dual form
        gram += damping * np.eye(gram.shape[-1])
        along = inputs @ (seen[own] - means[own])[..., None]
        x[own] += (np.linalg.solve(gram, along).mT @ outputs)[:, 0]
    return x


def _largest(weights: Array) -> Indices:
    """Return the examples of largest weight in each frame, shape (F, k)."""
    count = weights.shape[1]
    if count <= _MOST:
        return np.repeat(np.arange(count)[None], len(weights), axis=0)
    return np.argpartition(weights, -_MOST, axis=1)[:, -_MOST:]


def weights_around(
    rough: Array,
    comparison: KeyPoseComparison,
    examples: KeyExamples,
    pose_width: float,
    descriptor_width: float,
) -> Array:
    """Weight key poses by their similarity to a rough pose, and to what is seen.

    The kernels K_x(x̌, x_k) K_z(z, z_k) of Eq. 10, normalised: the rough pose x̌ settles which of
    several poses with the same silhouette is meant.

    Parameters
    ----------
    rough : ndarray, shape (F, D)
        x̌ of each frame.
    comparison : KeyPoseComparison
        Descriptors of the same frames.
    examples : KeyExamples
    pose_width, descriptor_width : float
        Standard deviations of the kernels.

    Returns
    -------
    weights : ndarray, shape (F, K)
        Each frame's sum to 1.
    """
    distances = examples.pose_distances(rough) / pose_width**2
    weights = kernel(distances + comparison.distances / descriptor_width**2, 1.0)
    return weights / weights.sum(axis=1, keepdims=True)
