"""The plane of shape contexts' first two principal components."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sklearn.decomposition import PCA

from silpose.core.types import Array, Array32
from silpose.descriptor.description import Description


@dataclass(frozen=True)
class ContextSpace:
    """Shape contexts, projected to their first two principal components.

    Attributes
    ----------
    contexts : ndarray, shape (n, 2)
        Contexts of training silhouettes.
    centres : ndarray, shape (K, 2)
        Centres of the codebook.
    points : list of ndarray, each of shape (P, 2)
        Contexts of the edge points of each frame.

    References
    ----------
    Fig. 2 of the paper.
    """

    contexts: Array
    centres: Array
    points: Sequence[Array]

    @classmethod
    def of(
        cls, contexts: Array, codebook: Array32, described: Sequence[Description]
    ) -> ContextSpace:
        """Find the plane of some contexts, and project a codebook and described masks to it.

        Parameters
        ----------
        contexts : ndarray, shape (n, B)
        codebook : ndarray, shape (K, B)
        described : sequence of Description

        Returns
        -------
        space : ContextSpace
        """
        pca = PCA(2).fit(contexts)
        return cls(
            pca.transform(contexts),
            pca.transform(codebook),
            [pca.transform(description.contexts) for description in described],
        )
