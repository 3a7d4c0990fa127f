"""The space of shape contexts: Fig. 2 of the paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from sklearn.decomposition import PCA

from silpose.descriptor import Description

Array = NDArray[np.float64]


@dataclass(frozen=True)
class ContextSpace:
    """The plane of the first two principal components of shape contexts.

    Attributes
    ----------
    contexts : ndarray, shape (n, 2)
        Of training silhouettes.
    centres : ndarray, shape (K, 2)
        Of the codebook.
    points : list of ndarray, each (P, 2)
        The edge points of each frame.
    """

    contexts: Array
    centres: Array
    points: Sequence[Array]

    @classmethod
    def of(
        cls, contexts: Array, codebook: NDArray[np.float32], seen: Sequence[Description]
    ) -> ContextSpace:
        """Find the plane of contexts (n, B); put a codebook (K, B) and described masks there."""
        pca = PCA(2).fit(contexts)
        return cls(
            pca.transform(contexts),
            pca.transform(codebook),
            [pca.transform(description.contexts) for description in seen],
        )
