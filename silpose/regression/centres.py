"""Training rows that carry a kernel, chosen over all frames in passes over blocks.

Whatever the blocks, rows are compared in batches of one size: the same rows are chosen in one go
and block by block.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

import numpy as np
from sklearn.cluster import MiniBatchKMeans

from silpose.core.types import Array, Indices

_BATCH = 4096  # rows, or the number of centres if that is more

Passes = Callable[[], Iterator[Array]]
"""Returns an iterator over all rows in blocks, (n, d) each."""


def choose_rows(
    choice: str, wanted: int, count: int, inputs: Passes, random: np.random.Generator
) -> Indices:
    """Choose rows.

    Parameters
    ----------
    choice : str
        One of `CHOICES`.
    wanted : int
        Number of rows to choose; k-means chooses fewer where rows are nearest to several means.
    count : int
        Number of all rows.
    inputs : callable
        Passes over them.
    random : Generator

    Returns
    -------
    rows : ndarray of int
        In order.
    """
    if not wanted or wanted == count:
        return np.arange(wanted)
    return np.sort(CHOICES[choice](wanted, count, inputs, random))


def evenly_spaced(count: int, most: int) -> Indices:
    """Return at most so many of `count` rows: of more, at even distances."""
    rows = min(count, most)
    return np.arange(rows) * count // max(rows, 1)


def batches(inputs: Iterator[Array], size: int) -> Iterator[Array]:
    """Divide rows anew, into batches of one size; the last may be smaller."""
    held: list[Array] = []
    rows = 0
    for block in inputs:
        while len(block):
            part, block = block[: size - rows], block[size - rows :]
            held.append(part)
            rows += len(part)
            if rows == size:
                yield np.concatenate(held)
                held, rows = [], 0
    if held:
        yield np.concatenate(held)


def _random(wanted: int, count: int, inputs: Passes, random: np.random.Generator) -> Indices:
    return random.choice(count, wanted, replace=False)


def _kmeans(wanted: int, count: int, inputs: Passes, random: np.random.Generator) -> Indices:
    """Choose the rows nearest to the means of a mini-batch k-means: two passes."""
    size = max(_BATCH, wanted)
    means = MiniBatchKMeans(
        wanted, init="random", n_init=1, random_state=int(random.integers(2**31))
    )
    for batch in batches(inputs(), size):
        means.partial_fit(batch)
    centres = means.cluster_centers_
    own = np.einsum("kd,kd->k", centres, centres)
    nearest, least, start = np.zeros(wanted, dtype=np.intp), np.full(wanted, np.inf), 0
    for batch in batches(inputs(), size):
        distances = batch @ (-2 * centres.T)
        distances += np.einsum("nd,nd->n", batch, batch)[:, None]
        distances += own
        here = distances.argmin(axis=0)
        found = distances[here, np.arange(wanted)]
        better = found < least
        nearest[better], least[better] = start + here[better], found[better]
        start += len(batch)
    return np.unique(nearest)


def _farthest(wanted: int, count: int, inputs: Passes, random: np.random.Generator) -> Indices:
    """Choose rows far from one another, of each batch and those chosen before: one pass.

    Within a constant factor as good as the greedy choice among all rows at once: P. Indyk et al.,
    "Composable core-sets for diversity and coverage maximization", PODS 2014.
    """
    rows, points, start = np.empty(0, dtype=np.intp), np.empty((0, 0)), 0
    for batch in batches(inputs(), max(_BATCH, 2 * wanted)):
        indices = start + np.arange(len(batch))
        start += len(batch)
        points = np.concatenate([points.reshape(-1, batch.shape[1]), batch])
        rows = np.concatenate([rows, indices])
        kept = _far_apart(points, wanted)
        points, rows = points[kept], rows[kept]
    return rows


def _far_apart(points: Array, wanted: int) -> Indices:
    """Choose each point that is farthest from those before, beginning with the first."""
    if len(points) <= wanted:
        return np.arange(len(points))
    own = np.einsum("nd,nd->n", points, points)
    chosen, distance = [0], np.full(len(points), np.inf)
    while len(chosen) < wanted:
        last = chosen[-1]
        np.minimum(distance, own - 2 * (points @ points[last]) + own[last], out=distance)
        distance[last] = -np.inf  # copies of a point may be chosen, but itself not again
        chosen.append(int(distance.argmax()))
    return np.array(chosen)


CHOICES: Mapping[str, Callable[[int, int, Passes, np.random.Generator], Indices]] = {
    "random": _random,
    "kmeans": _kmeans,
    "farthest": _farthest,
}
