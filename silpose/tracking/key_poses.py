"""Key poses: the few training examples' worth of pose space over which a tracker's belief lies.

Clusters of training poses. Each knows the mean pose and the mean descriptor of its frames, and
where they went next.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import csr_array
from sklearn.cluster import KMeans

from silpose.core.errors import InputError
from silpose.core.pose_space import PoseSpace
from silpose.regression.mixture.reduction import whitening
from silpose.tracking.silhouette_regressor import SilhouetteRegressor

Array = NDArray[np.float64]
Examples = Sequence[tuple[Array, Array]]


@dataclass(frozen=True)
class KeyPoseComparison:
    """Frames as they compare with key poses.

    Attributes
    ----------
    descriptors : ndarray, shape (F, d)
        Whitened; NaN where there was nothing to see.
    distances : ndarray, shape (F, K)
        Squared, to key poses' descriptors, in their spread; 0 where there was nothing to see.
    """

    descriptors: Array
    distances: Array

    @property
    def blank(self) -> NDArray[np.bool_]:
        """Where there was nothing to see, shape (F,)."""
        return np.asarray(np.isnan(self.descriptors).any(axis=1))


@dataclass(frozen=True)
class KeyExamples:
    """Key poses and what they look like: with these, poses and descriptors are compared.

    Attributes
    ----------
    mean, scale : ndarray, shape (D,)
        By which poses are standardised. A column's scale is the geometric mean of its standard
        deviation and of one unit of the reported metric: of the deviation alone, angles that
        hardly move would weigh as much as a leg's, of the unit alone, the heading nearly all.
    whitening : ndarray, shape (d, d)
        Of square roots of descriptors: divides by their scatter within key poses, so that
        what varies although the pose does not counts less.
    poses : ndarray, shape (K, D)
        Standardised.
    descriptors : ndarray, shape (K, d)
        Whitened.
    spread : float
        Mean squared distance of a frame's whitened descriptor to its key pose's.
    """

    mean: Array
    scale: Array
    whitening: Array
    poses: Array
    descriptors: Array
    spread: float

    @property
    def headings(self) -> Array:
        """Cos and sin of each key pose's heading, shape (K, 2)."""
        return self.poses[:, :2] * self.scale[:2] + self.mean[:2]

    def see(self, z: ArrayLike) -> KeyPoseComparison:
        """Compare descriptors (F, d); what is not finite was not seen."""
        z, columns = np.asarray(z, dtype=float), len(self.whitening)
        if z.ndim != 2 or z.shape[1] != columns:
            raise InputError(f"descriptors have shape {z.shape}: expected (frames, {columns})")
        if len(z) == 0:
            raise InputError("there is no frame to track")
        blank = ~np.isfinite(z).all(axis=1)
        seen = np.sqrt(np.where(blank[:, None], 0, np.maximum(z, 0))) @ self.whitening
        distances = self.descriptor_distances(seen)
        seen[blank], distances[blank] = np.nan, 0
        return KeyPoseComparison(seen, distances)

    def pose_distances(self, x: Array) -> Array:
        """Mean squared difference of poses (n, D) to key poses, shape (n, K)."""
        return squared_distances((x - self.mean) / self.scale, self.poses) / len(self.mean)

    def descriptor_distances(self, seen: Array) -> Array:
        """Squared distance of whitened descriptors (n, d) to key poses', in `spread`, (n, K)."""
        distances = squared_distances(seen, self.descriptors)
        distances /= self.spread
        return distances


@dataclass(frozen=True)
class KeyPoses:
    """Key poses of some training sequences, before kernel widths are chosen.

    Attributes
    ----------
    examples : KeyExamples
    poses, following : ndarray, shape (n, D)
        Of each training frame, and after it, standardised.
    seen : ndarray, shape (n, d)
        Whitened descriptors of training frames.
    members : csr_array, shape (K, n)
        Rows average over the frames of each key pose.
    """

    examples: KeyExamples
    poses: Array
    following: Array
    seen: Array
    members: csr_array

    @classmethod
    def of(cls, sequences: Examples, space: PoseSpace, keep: float, seed: int | None) -> KeyPoses:
        """Cluster the poses of training sequences ``(z, x)``, into a share `keep` of the frames."""
        if not 0 < keep <= 1:
            raise InputError(f"keep is a share of the training frames up to 1, not {keep}")
        x = np.concatenate([x for _, x in sequences])
        deviation = np.maximum(x.std(axis=0), 1e-3 * space.units)
        mean, scale = x.mean(axis=0), np.sqrt(deviation * space.units)
        takes = [(x - mean) / scale for _, x in sequences]
        following = np.concatenate([_following(take) for take in takes])
        poses = np.concatenate(takes)
        count = min(max(1, int(keep * len(poses))), len(np.unique(poses, axis=0)))
        labels = KMeans(count, n_init=1, random_state=seed).fit(poses).labels_
        kept, labels = np.unique(labels, return_inverse=True)
        size = np.bincount(labels)
        frames = np.arange(len(poses))
        members = csr_array((1 / size[labels], (labels, frames)), shape=(len(kept), len(poses)))
        roots = np.sqrt(np.concatenate([z for z, _ in sequences]))
        directions = whitening(roots - (members @ roots)[labels])
        seen = roots @ directions
        centres, descriptors = members @ poses, members @ seen
        within = seen - descriptors[labels]
        spread = max(float((within**2).sum(axis=1).mean()), 1e-12)
        examples = KeyExamples(mean, scale, directions, centres, descriptors, spread)
        return cls(examples, poses, following, seen, members)

    def transitions(self, width: float, restart: float) -> Array:
        """Probability (K, K) that one key pose follows another, a frame later.

        The pose kernel of Eq. 10 between where a key pose's frames went and every key pose, of
        standard deviation `width` per column; with probability `restart` it is any.
        """
        poses = self.examples.poses
        near = kernel(squared_distances(self.following, poses) / poses.shape[1], width)
        near /= near.sum(axis=1, keepdims=True)
        return (1 - restart) * (self.members @ near) + restart / len(poses)

    @property
    def sizes(self) -> Array:
        """Number of training frames in each key pose, shape (K,)."""
        return np.diff(self.members.indptr).astype(float)

    @cached_property
    def silhouette_alone(self) -> SilhouetteRegressor:
        """A regressor that knows nothing of the frames before."""
        return SilhouetteRegressor.fit(self.examples.descriptor_distances(self.seen), self.poses)


def kernel(distances: Array, width: float) -> Array:
    """Gaussian of squared distances (F, K), scaled so that the largest of a frame is 1."""
    nearest = distances.min(axis=1, keepdims=True)
    return np.exp((nearest - distances) / (2 * width**2))


def squared_distances(a: Array, b: Array) -> Array:
    """Squared Euclidean distances of rows, shape (n, m)."""
    distances = a @ (-2 * b.T)  # large: change it in place
    distances += (a**2).sum(axis=1)[:, None]
    distances += (b**2).sum(axis=1)
    return np.maximum(distances, 0, out=distances)


def _following(take: Array) -> Array:
    """Give the pose after each; after the last, what its velocity leads to."""
    last = 2 * take[-1:] - take[-2:-1] if len(take) > 1 else take[-1:]
    return np.vstack([take[1:], last])
