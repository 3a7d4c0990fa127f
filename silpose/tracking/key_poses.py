"""Key poses: clusters of training poses, over which a tracker's belief is distributed.

Each has the mean pose and the mean descriptor of its frames, and the poses that followed them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array
from sklearn.cluster import KMeans

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array, Examples
from silpose.regression.mixture import whitening
from silpose.tracking.silhouette_regressor import SilhouetteRegressor


@dataclass(frozen=True)
class KeyPoseComparison:
    """Descriptors of frames in comparison with those of key poses.

    Attributes
    ----------
    descriptors : ndarray, shape (F, d)
        Whitened; NaN where there was nothing to see.
    distances : ndarray, shape (F, K)
        Squared distances to key poses' descriptors, in units of their spread; 0 where there was
        nothing to see.
    """

    descriptors: Array
    distances: Array

    @property
    def blank(self) -> NDArray[np.bool_]:
        """Where there was nothing to see, shape (F,)."""
        return np.asarray(np.isnan(self.descriptors).any(axis=1))


@dataclass(frozen=True)
class KeyExamples:
    """Poses and descriptors of key poses, with which others are compared.

    Attributes
    ----------
    mean, scale : ndarray, shape (D,)
        By which poses are standardised. A column's scale is the geometric mean of its standard
        deviation and of one unit of the reported metric: with the deviation alone, angles that
        hardly move would weigh as much as a leg's, with the unit alone, the heading nearly all.
    whitening : ndarray, shape (d, d)
        Applied to square roots of descriptors: divides by their scatter within key poses, so that
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

    def compare(self, z: Array) -> KeyPoseComparison:
        """Compare descriptors (F, d); what is not finite was not seen."""
        blank = np.asarray(~np.isfinite(z).all(axis=1))
        seen = np.sqrt(np.where(blank[:, None], 0, np.maximum(z, 0))) @ self.whitening
        distances = self.descriptor_distances(seen)
        seen[blank], distances[blank] = np.nan, 0
        return KeyPoseComparison(seen, distances)

    def pose_distances(self, x: Array) -> Array:
        """Mean squared difference of poses (n, D) to key poses, shape (n, K)."""
        return squared_distances((x - self.mean) / self.scale, self.poses) / len(self.mean)

    def descriptor_distances(self, seen: Array) -> Array:
        """Squared distances of whitened descriptors (n, d) to key poses', over `spread`, (n, K)."""
        distances = squared_distances(seen, self.descriptors, self._squared_lengths)
        distances /= self.spread
        return distances

    @cached_property
    def _squared_lengths(self) -> Array:
        """Of key poses' descriptors, which takes longer to find than a frame's distances."""
        return np.asarray((self.descriptors**2).sum(axis=1))


@dataclass(frozen=True)
class KeyPoses:
    """Key poses of some training takes, before kernel widths are chosen.

    Attributes
    ----------
    examples : KeyExamples
    poses, following : ndarray, shape (n, D)
        Pose of each training frame, and of the frame after it, standardised.
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
    def fit(cls, takes: Examples, space: PoseSpace, keep: float, seed: int | None) -> Self:
        """Cluster the poses of training takes.

        Parameters
        ----------
        takes : sequence of (z, x)
            Descriptors (F, d) and poses (F, D) of each take.
        space : PoseSpace
        keep : float
            Number of key poses as a share of the frames.
        seed : int or None
            Seed of k-means.
        """
        x = np.concatenate([x for _, x in takes])
        deviation = np.maximum(x.std(axis=0), 1e-3 * space.units)
        mean, scale = x.mean(axis=0), np.sqrt(deviation * space.units)
        standardised = [(x - mean) / scale for _, x in takes]
        following = np.concatenate([_following(take) for take in standardised])
        poses = np.concatenate(standardised)
        count = min(max(1, int(keep * len(poses))), len(np.unique(poses, axis=0)))
        labels = KMeans(count, n_init=1, random_state=seed).fit(poses).labels_
        kept, labels = np.unique(labels, return_inverse=True)
        size = np.bincount(labels)
        frames = np.arange(len(poses))
        members = csr_array((1 / size[labels], (labels, frames)), shape=(len(kept), len(poses)))
        roots = np.sqrt(np.concatenate([z for z, _ in takes]))
        directions = whitening(roots - (members @ roots)[labels])
        seen = roots @ directions
        centres, descriptors = members @ poses, members @ seen
        within = seen - descriptors[labels]
        spread = max(float((within**2).sum(axis=1).mean()), 1e-12)
        examples = KeyExamples(mean, scale, directions, centres, descriptors, spread)
        return cls(examples, poses, following, seen, members)

    def transitions(self, width: float, restart: float) -> Array:
        """Return the probability that one key pose follows another a frame later.

        It is the pose kernel of Eq. 10 between where a key pose's frames went and every key pose.

        Parameters
        ----------
        width : float
            Standard deviation of the kernel, per standardised column.
        restart : float
            Probability that any key pose follows.

        Returns
        -------
        transitions : ndarray, shape (K, K)
            Rows sum to 1.
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
        """A regressor that ignores the frames before."""
        return SilhouetteRegressor.fit(self.examples.descriptor_distances(self.seen), self.poses)


def kernel(distances: Array, width: float) -> Array:
    """Gaussian of squared distances (F, K), scaled so that the largest of a frame is 1."""
    nearest = distances.min(axis=1, keepdims=True)
    return np.exp((nearest - distances) / (2 * width**2))


def squared_distances(a: Array, b: Array, lengths: Array | None = None) -> Array:
    """Squared Euclidean distances of rows, shape (n, m); squared lengths of b's may be known."""
    few = len(a) < len(b)  # copied with its factor
    distances = (-2 * a) @ b.T if few else a @ (-2 * b.T)  # large: change it in place
    distances += (a**2).sum(axis=1)[:, None]
    distances += (b**2).sum(axis=1) if lengths is None else lengths
    return np.maximum(distances, 0, out=distances)


def _following(take: Array) -> Array:
    """Return the pose after each; after the last, its extrapolation at constant velocity."""
    last = 2 * take[-1:] - take[-2:-1] if len(take) > 1 else take[-1:]
    return np.vstack([take[1:], last])
