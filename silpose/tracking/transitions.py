"""Probabilities that one key pose follows another, stored for near ones only.

Most key poses never follow most others: what a transition has beyond the share of all, a restart,
is kept sparse, the share itself by two vectors. Memory and time then depend on how many key poses
a key pose has near it. Where these are most of all, as for few key poses and a wide kernel, the
whole matrix is faster.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np
from scipy.sparse import csr_array, diags_array

from silpose.core.serialisation import State
from silpose.core.types import Array
from silpose.tracking.distances import FEW

_LOST = 1e-6  # share of what is always left by a restart; the rest is kept
_IMPROBABLE = 0.1  # share of what a restart leaves
_DENSE = 1 / 3  # share of entries from which a product with the whole matrix is faster
_SPARSE = ("values", "columns", "starts")
_FOR_NO_RESTART = 1e-6  # what counts as their probability where there are none


@dataclass(frozen=True)
class Transitions:
    """The matrix N + l aᵀ of K key poses.

    Attributes
    ----------
    near : csr_array or ndarray, shape (K, K)
        N, sparse unless it is dense.
    leaving : ndarray, shape (K,)
        l: probability that a restart follows.
    arriving : ndarray, shape (K,)
        a: where restarts go.
    """

    near: csr_array | Array
    leaving: Array
    arriving: Array

    @classmethod
    def of(cls, near: csr_array, restart: float) -> Self:
        """Mix transitions to near key poses with a restart anywhere.

        Parameters
        ----------
        near : csr_array, shape (K, K)
            Rows sum to 1.
        restart : float
            Probability that any key pose follows.
        """
        count = near.shape[0]
        known: csr_array | Array = near.toarray() if near.nnz > _DENSE * count**2 else near
        return cls((1 - restart) * known, np.full(count, restart), np.full(count, 1 / count))

    @classmethod
    def of_dense(cls, matrix: Array) -> Self:
        """Take over a whole matrix (K, K), of which nothing is dropped."""
        count = len(matrix)
        return cls(matrix, np.zeros(count), np.full(count, 1 / count))

    @staticmethod
    def negligible(count: int, restart: float) -> float:
        """Return the probability below which a transition between `count` key poses is dropped.

        A millionth of what a restart gives to each key pose anyhow, so that predictions change by
        a millionth at most, and far less where they matter. Without restarts, as with 1e-6.
        """
        return _LOST * (restart or _FOR_NO_RESTART) / count

    def forward(self, belief: Array) -> Array:
        """Predict the next belief (K,) from a belief (K,).

        Of more than `FEW` key poses, those that are less probable than a tenth of what a restart
        leaves to each restart, so that time grows with the others.
        """
        share = float(belief @ self.leaving)
        if isinstance(self.near, np.ndarray) or len(belief) <= FEW:
            return np.asarray(belief @ self.near + share * self.arriving)
        count = len(belief)
        probable = np.flatnonzero(belief > _IMPROBABLE * (share or _FOR_NO_RESTART) / count)
        own = belief[probable]
        row = csr_array((own, probable, np.array([0, len(probable)])), shape=(1, count)) @ self.near
        predicted = np.bincount(row.indices, row.data, minlength=count)
        rest = belief.sum() - predicted.sum() if share else 0.0
        return np.asarray(predicted + rest * self.arriving)

    def backward(self, likelihoods: Array) -> Array:
        """Expect likelihoods (F, K) of the next frames, given each key pose before, (F, K)."""
        restarted = np.outer(likelihoods @ self.arriving, self.leaving)
        return np.asarray((self.near @ likelihoods.T).T + restarted)

    def reversed(self, sizes: Array) -> Self:
        """Return the transitions of time going backwards, by Bayes' rule with prior sizes (K,)."""
        into = sizes @ self.near + (sizes @ self.leaving) * self.arriving
        never = into == 0  # without restarts, a key pose may have none before it: it stays
        into = np.where(never, 1, into)
        if isinstance(self.near, np.ndarray):
            near = (sizes[:, None] * self.near / into).T + np.diag(never)
        else:
            near = (diags_array(sizes) @ self.near @ diags_array(1 / into)).T
            near = csr_array(near + diags_array(never.astype(float)))
        start = self.leaving * sizes
        start = start / start.sum() if start.any() else sizes / sizes.sum()
        return type(self)(near, self.arriving / into * (self.leaving @ sizes), start)

    @property
    def stored(self) -> int:
        """Number of entries that are stored."""
        return int(self.near.size)

    def dense(self) -> Array:
        """Return the whole matrix, shape (K, K)."""
        near = self.near if isinstance(self.near, np.ndarray) else self.near.toarray()
        whole: Array = near + np.outer(self.leaving, self.arriving)
        return whole

    def to_arrays(self) -> State:
        """Return the matrix as arrays."""
        own: State = {"leaving": self.leaving, "arriving": self.arriving}
        if isinstance(self.near, np.ndarray):
            return own | {"near": self.near}
        parts = (self.near.data, self.near.indices, self.near.indptr)
        return own | dict(zip(_SPARSE, parts, strict=True))

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore it from the result of `to_arrays`."""
        own = {name: np.asarray(value) for name, value in state.items()}
        near = own.get("near")
        if near is None:
            shape = (len(own["leaving"]),) * 2
            near = csr_array(tuple(own[name] for name in _SPARSE), shape=shape)
        return cls(near, own["leaving"], own["arriving"])
