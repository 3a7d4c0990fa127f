"""Which frames are of one key pose: k-means over poses, in memory or in batches."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from sklearn.cluster import KMeans, MiniBatchKMeans

from silpose.core.types import Array, Indices
from silpose.regression.centres import batches
from silpose.tracking.distances import FEW

# A round of k-means takes time in proportion to clusters times frames, there are tens of them, and
# its careful start takes as long as some more. Batches take one round and a start at random frames,
# and hold no more frames than clusters at a time.
_MOST_FRAMES = 50_000
_BATCH = 4096


def cluster_poses(
    blocks: Callable[[], Iterator[Array]], frames: int, keep: float, seed: int | None
) -> Indices:
    """Cluster poses.

    Parameters
    ----------
    blocks : callable
        Returns an iterator over all poses, standardised, in blocks (F, D); called anew for every
        pass.
    frames : int
        Number of poses.
    keep : float
        Number of clusters as a share of the frames. Beyond `FEW` clusters or 50,000 frames, they
        are the means of one pass over batches.
    seed : int or None

    Returns
    -------
    labels : ndarray of int, shape (frames,)
        Consecutive numbers from 0.
    """
    count = max(1, int(keep * frames))
    if count <= FEW and frames <= _MOST_FRAMES:
        poses = np.concatenate(list(blocks()))
        count = min(count, len(np.unique(poses, axis=0)))
        labels = KMeans(count, n_init=1, random_state=seed).fit(poses).labels_
    else:
        labels = _in_batches(blocks, frames, count, seed)
    return np.unique(labels, return_inverse=True)[1].astype(np.int32)


def _in_batches(
    blocks: Callable[[], Iterator[Array]], frames: int, count: int, seed: int | None
) -> Indices:
    chosen = np.zeros(frames, dtype=bool)
    chosen[np.random.default_rng(seed).choice(frames, count, replace=False)] = True
    first, start = [], 0
    for block in blocks():
        first.append(block[chosen[start : start + len(block)]])
        start += len(block)
    # Takes come one after the other: a mean that none needed yet is no mean to give up.
    means = MiniBatchKMeans(count, init=np.concatenate(first), n_init=1, reassignment_ratio=0.0)
    for batch in batches(blocks(), max(_BATCH, count)):
        means.partial_fit(batch)
    return np.concatenate([means.predict(block) for block in blocks()])
