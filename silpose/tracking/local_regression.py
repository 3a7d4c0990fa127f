"""Locally weighted regression: what the key poses that are believed in say of the rest.

W. S. Cleveland, S. J. Devlin, "Locally weighted regression", J. Am. Stat. Assoc. 1988.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from silpose.tracking.key_poses import KeyPoses, squared_distances

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


@dataclass(frozen=True)
class LocalRegression:
    """Regression on the examples around a pose that is known roughly.

    The kernels K_x(x̌, x_k) K_z(z, z_k) of Eq. 10, normalised, weigh key poses; on these the pose
    is regressed, linearly in the descriptor. So the rough pose settles which of the poses that
    look alike is meant, and the silhouette where between key poses it lies.

    Attributes
    ----------
    mean, scale : ndarray, shape (D,)
    whitening : ndarray, shape (d, d)
    poses, descriptors : ndarray, shapes (K, D) and (K, d)
    spread : float
        As `KeyPoses` explains them.
    pose_width, descriptor_width, damping : float
        As `Tracker` explains them.
    """

    mean: Array
    scale: Array
    whitening: Array
    poses: Array
    descriptors: Array
    spread: float
    pose_width: float
    descriptor_width: float
    damping: float

    @classmethod
    def on(
        cls, keys: KeyPoses, pose_width: float, descriptor_width: float, damping: float
    ) -> LocalRegression:
        """Take key poses for examples."""
        return cls(
            keys.mean, keys.scale, keys.whitening, keys.poses, keys.descriptors, keys.spread,
            pose_width, descriptor_width, damping,
        )  # fmt: skip

    def estimate(self, rough: Array, z: Array) -> Array:
        """Estimate the pose (D,) of a descriptor (d,) that is not blank, near a rough one (D,)."""
        seen = np.sqrt(np.maximum(z, 0))[None] @ self.whitening
        near = squared_distances(((rough - self.mean) / self.scale)[None], self.poses)[0]
        alike = squared_distances(seen, self.descriptors)[0]
        exponent = near / (2 * self.pose_width**2 * len(self.mean))
        exponent += alike / (2 * self.descriptor_width**2 * self.spread)
        weights = np.exp(exponent.min() - exponent)
        weights /= weights.sum()
        pose = regress_locally(weights, self.poses, self.descriptors, seen[0], self.damping)
        return pose * self.scale + self.mean
