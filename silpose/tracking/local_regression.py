"""Locally weighted regression of the pose on the key poses with most weight.

W. S. Cleveland, S. J. Devlin, "Locally weighted regression", J. Am. Stat. Assoc. 1988.
"""

from __future__ import annotations

import numpy as np

from silpose.core.types import Array
from silpose.tracking.key_poses import KeyExamples, KeyPoseComparison, kernel

_MOST = 64  # examples of largest weight that are regressed on; more hardly matter, but cost


def regress_locally(
    weights: Array, poses: Array, descriptors: Array, seen: Array, damping: float
) -> Array:
    """Estimate a pose by ridge regression, linear in the descriptor, around a weighted mean.

    Parameters
    ----------
    weights : ndarray, shape (K,)
        Weights of the examples, which sum to 1.
    poses, descriptors : ndarray, shapes (K, D) and (K, d)
        Examples.
    seen : ndarray, shape (d,)
        Where to evaluate; with NaN, for nothing seen, the weighted mean is returned.
    damping : float
        λ of the squared slope: the larger, the nearer the pose stays to the weighted mean.

    Returns
    -------
    pose : ndarray, shape (D,)
    """
    pose = weights @ poses
    if np.isnan(seen).any():
        return pose
    descriptor = weights @ descriptors
    some = np.argpartition(weights, -_MOST)[-_MOST:] if len(weights) > _MOST else slice(None)
    root = np.sqrt(weights[some])[:, None]
    inputs, outputs = root * (descriptors[some] - descriptor), root * (poses[some] - pose)
    gram = inputs @ inputs.T  # fewer examples than inputs: the dual form
    gram.flat[:: len(gram) + 1] += damping
    change: Array = np.linalg.solve(gram, inputs @ (seen - descriptor)) @ outputs
    return pose + change


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
