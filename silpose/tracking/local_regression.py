"""Locally weighted regression: what the key poses that are believed in say of the rest.

W. S. Cleveland, S. J. Devlin, "Locally weighted regression", J. Am. Stat. Assoc. 1988.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from silpose.tracking.key_poses import KeyExamples, KeyPoseComparison, kernel

Array = NDArray[np.float64]

_HEARD = 64  # examples of most weight; more hardly matter, but cost


def regress_locally(
    weights: Array, poses: Array, descriptors: Array, seen: Array, damping: float
) -> Array:
    """Estimate a pose by ridge regression, linear in the descriptor, around a weighted mean.

    Parameters
    ----------
    weights : ndarray, shape (K,)
        Of the examples; they sum to 1.
    poses, descriptors : ndarray, shapes (K, D) and (K, d)
        Examples.
    seen : ndarray, shape (d,)
        Where to evaluate; with NaN, for nothing, the mean pose is all that can be said.
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
    heard = np.argpartition(weights, -_HEARD)[-_HEARD:] if len(weights) > _HEARD else slice(None)
    root = np.sqrt(weights[heard])[:, None]
    inputs, outputs = root * (descriptors[heard] - descriptor), root * (poses[heard] - pose)
    gram = inputs @ inputs.T  # fewer examples than inputs: the dual form
    gram.flat[:: len(gram) + 1] += damping
    change: Array = np.linalg.solve(gram, inputs @ (seen - descriptor)) @ outputs
    return pose + change


def weights_around(
    rough: Array,
    sight: KeyPoseComparison,
    examples: KeyExamples,
    pose_width: float,
    descriptor_width: float,
) -> Array:
    """Weigh key poses by a pose that is known roughly, and by what is seen.

    The kernels K_x(x̌, x_k) K_z(z, z_k) of Eq. 10, normalised: the rough pose x̌ settles which of
    the poses that look alike is meant.

    Parameters
    ----------
    rough : ndarray, shape (F, D)
    sight : KeyPoseComparison
        Of as many frames.
    examples : KeyExamples
    pose_width, descriptor_width : float
        Standard deviations of the kernels.

    Returns
    -------
    weights : ndarray, shape (F, K)
        Each frame's sum to 1.
    """
    distances = examples.pose_distances(rough) / pose_width**2
    weights = kernel(distances + sight.distances / descriptor_width**2, 1.0)
    return weights / weights.sum(axis=1, keepdims=True)
