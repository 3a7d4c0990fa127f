"""Key poses: clusters of training poses, over which a tracker's belief is distributed.

Each has the mean pose and the mean descriptor of its frames, and the poses that followed them. All
is summed over blocks of frames: memory depends on the number of key poses, and of a frame only the
number of its key pose is kept.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np
from scipy.sparse import csr_array, vstack

from silpose.core.errors import InputError
from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array, Indices
from silpose.regression.mixture import whitening
from silpose.regression.moments import Moments
from silpose.tracking.distances import FEW, rows_at_once, squared_distances
from silpose.tracking.key_examples import KeyExamples
from silpose.tracking.pose_clusters import cluster_poses
from silpose.tracking.silhouette_regressor import SilhouetteRegressor, centres_among
from silpose.tracking.takes import FRAMES, Frames, TrainingTakes
from silpose.tracking.transitions import Transitions

_HELD = 8_000_000  # similarities that are in memory before they are averaged


@dataclass(frozen=True)
class KeyPoses:
    """Key poses of some training takes, before kernel widths are chosen.

    Attributes
    ----------
    examples : KeyExamples
    takes : TrainingTakes
    labels : ndarray of int, shape (n,)
        Key pose of each training frame.
    """

    examples: KeyExamples
    takes: TrainingTakes
    labels: Indices

    @classmethod
    def fit(cls, takes: TrainingTakes, space: PoseSpace, keep: float, seed: int | None) -> Self:
        """Cluster the poses of training takes.

        Parameters
        ----------
        takes : TrainingTakes
        space : PoseSpace
        keep : float
            Number of key poses as a share of the frames.
        seed : int or None
            Seed of k-means.
        """
        whole = Moments.total(Moments.of_outputs(block.x) for block in takes.blocks())
        if takes.columns[1] != len(space.columns):
            raise InputError(
                f"poses have {takes.columns[1]} columns: in the space '{space.name}' they have "
                f"{len(space.columns)}"
            )
        deviation = np.maximum(np.sqrt(whole.squares / whole.count), 1e-3 * space.units)
        mean, scale = whole.mean_y, np.sqrt(deviation * space.units)

        def standardised() -> Iterator[Array]:
            return ((block.x - mean) / scale for block in takes.blocks())

        labels = cluster_poses(standardised, whole.count, keep, seed)
        sizes = np.bincount(labels)
        means = np.zeros((len(sizes), sum(takes.columns)))
        for block, own in _labelled(takes, labels):
            rows = np.hstack([(block.x - mean) / scale, np.sqrt(block.z)])
            means += _members(own, 1 / sizes) @ rows
        poses, roots = means[:, : len(mean)], means[:, len(mean) :]
        scatter = np.zeros((takes.columns[0], takes.columns[0]))
        for block, own in _labelled(takes, labels):
            within = np.sqrt(block.z) - roots[own]
            scatter += within.T @ within
        scatter /= whole.count
        directions = whitening(scatter)
        spread = max(float(np.einsum("ij,ij->", scatter @ directions, directions)), 1e-12)
        examples = KeyExamples(mean, scale, directions, poses, roots @ directions, spread)
        return cls(examples, takes, labels)

    def transitions(self, width: float, restart: float) -> Transitions:
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
        transitions : Transitions
            Without those that are negligible beside a restart, and those beyond the `FEW` nearest
            to where a frame went.
        """
        count = len(self.sizes)
        reach = -2 * width**2 * np.log(Transitions.negligible(count, restart))
        near, held, owners = csr_array((count, count)), [], []
        for block, own in _labelled(self.takes, self.labels, rows_at_once(count)):
            held.append(_near(self.examples.pose_distances(block.following), width, reach))
            owners.append(own)
            if sum(rows.nnz for rows in held) > _HELD:
                near = near + _members(np.concatenate(owners), 1 / self.sizes) @ vstack(held)
                held, owners = [], []
        if held:
            near = near + _members(np.concatenate(owners), 1 / self.sizes) @ vstack(held)
        return Transitions.of(near.tocsr(), restart)

    @cached_property
    def sizes(self) -> Array:
        """Number of training frames in each key pose, shape (K,)."""
        return np.bincount(self.labels).astype(float)

    @cached_property
    def silhouette_alone(self) -> SilhouetteRegressor:
        """A regressor that ignores the frames before."""
        own = self.examples
        centres = own.descriptors[centres_among(len(own.descriptors))]

        def moments(block: Frames) -> Moments:
            distances = squared_distances(np.sqrt(block.z) @ own.whitening, centres) / own.spread
            return SilhouetteRegressor.moments(distances, (block.x - own.mean) / own.scale)

        most = min(FRAMES, rows_at_once(len(centres)))
        return SilhouetteRegressor.of(Moments.total(map(moments, self.takes.blocks(most))))


def _labelled(
    takes: TrainingTakes, labels: Indices, most: int = FRAMES
) -> Iterator[tuple[Frames, Indices]]:
    """Iterate over frames in blocks, and over the key pose of each."""
    start = 0
    for block in takes.blocks(most):
        yield block, labels[start : start + len(block.x)]
        start += len(block.x)


def _members(labels: Indices, weights: Array) -> csr_array:
    """Matrix (K, n) that sums over the frames of each key pose, with its weight (K,)."""
    frames = np.arange(len(labels))
    return csr_array((weights[labels], (labels, frames)), shape=(len(weights), len(labels)))


def _near(distances: Array, width: float, reach: float) -> csr_array:
    """Kernels of squared distances (n, K), up to `reach` beyond the least; rows sum to 1."""
    distances = distances - distances.min(axis=1, keepdims=True)
    near = distances <= reach
    for row in np.flatnonzero(near.sum(axis=1) > FEW):
        near[row] = distances[row] <= np.partition(distances[row], FEW)[FEW]
    rows, columns = np.nonzero(near)
    values = np.exp(distances[rows, columns] / (-2 * width**2))
    starts = np.concatenate([[0], np.cumsum(np.bincount(rows))])
    values /= np.repeat(np.add.reduceat(values, starts[:-1]), np.diff(starts))
    return csr_array((values, columns, starts), shape=distances.shape)
