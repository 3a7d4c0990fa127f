"""The histogram of shape contexts: one vector z per silhouette."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
from os import cpu_count
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, TransformerMixin
from sklearn.utils.validation import check_is_fitted

from silpose.descriptor.boundary import as_mask, boundary_pixels, spaced_indices
from silpose.descriptor.codebook import (
    learn_codebook,
    soft_votes,
    squared_distances,
    typical_distance,
)
from silpose.descriptor.shape_context import ring_bounds, sector_table, shape_contexts
from silpose.errors import InputError

Masks = NDArray[Any] | Sequence[ArrayLike]

_table = lru_cache(maxsize=8)(sector_table)


@dataclass(frozen=True)
class Description:
    """How one mask becomes its histogram.

    Attributes
    ----------
    points : ndarray, shape (P, 2)
        Edge points, pixels.
    contexts : ndarray, shape (P, B)
        Their shape contexts.
    nearest : ndarray of int, shape (P,)
        The codebook centre nearest to each.
    z : ndarray, shape (K,)
        The histogram.
    """

    points: NDArray[np.int32]
    contexts: NDArray[np.float32]
    nearest: NDArray[np.intp]
    z: NDArray[np.float64]


class ShapeContextHistogram(TransformerMixin, BaseEstimator):
    """Histogram of shape contexts, softly voted into a learnt codebook (section II-A).

    Parameters
    ----------
    edge_points : int
        Regularly spaced points on the boundary at which contexts are taken.
    angular_bins, radial_bins : int
        Of a context; the rings grow by equal factors.
    radius : float
        Reach of a context, relative to the silhouette's size, which is the root mean square
        distance of its boundary from its centre: 0.3 of a standing person's height.
    inner_radius : float
        Outer radius of the innermost ring, relative to `radius`.
    codebook_size : int
        Number of centres.
    voters : int
        Centres that each context votes into.
    vote_width : float
        Standard deviation of a vote, relative to the typical distance of a training context
        to its nearest centre.
    max_contexts : int
        At most so many contexts, drawn from those of all masks, go into k-means.
    random_state : int or None
    n_jobs : int or None
        Threads; None is one per processor. The result does not depend on it.

    Attributes
    ----------
    codebook_ : ndarray, shape (codebook_size, radial_bins * angular_bins)
    vote_width_ : float
        In units of contexts.

    Examples
    --------
    >>> masks = [[[0, 1, 1], [0, 1, 0], [1, 1, 0]], [[1, 1, 1], [0, 1, 0], [0, 1, 0]]]
    >>> ShapeContextHistogram(edge_points=6, codebook_size=4).fit_transform(masks).shape
    (2, 4)
    """

    def __init__(
        self,
        edge_points: int = 200,
        angular_bins: int = 12,
        radial_bins: int = 5,
        radius: float = 0.45,
        inner_radius: float = 0.1,
        codebook_size: int = 100,
        voters: int = 8,
        vote_width: float = 0.7,
        max_contexts: int = 50_000,
        random_state: int | None = 0,
        n_jobs: int | None = None,
    ) -> None:
        self.edge_points = edge_points
        self.angular_bins = angular_bins
        self.radial_bins = radial_bins
        self.radius = radius
        self.inner_radius = inner_radius
        self.codebook_size = codebook_size
        self.voters = voters
        self.vote_width = vote_width
        self.max_contexts = max_contexts
        self.random_state = random_state
        self.n_jobs = n_jobs

    def fit(self, masks: Masks, y: object = None) -> ShapeContextHistogram:
        """Learn the codebook.

        Parameters
        ----------
        masks : array-like, shape (n, H, W), or list of arrays of any shapes (H, W)
            Not 0 is foreground.
        """
        self._check_parameters()
        checked = _checked(masks)
        random = np.random.default_rng(self.random_state)
        # Contexts of all masks, but not all contexts: as many from each.
        share = max(1, min(self.edge_points, self.max_contexts // len(checked)))
        picks = [random.choice(self.edge_points, share, replace=False) for _ in checked]
        described = self._map(lambda mask: self._contexts(mask)[1], checked)
        contexts = np.concatenate([c[p] for c, p in zip(described, picks, strict=True)])
        self.codebook_ = learn_codebook(contexts, self.codebook_size, self.random_state)
        self.vote_width_ = self.vote_width * typical_distance(contexts, self.codebook_)
        return self

    def transform(self, masks: Masks) -> NDArray[np.float64]:
        """Describe masks.

        Parameters
        ----------
        masks : array-like, shape (n, H, W), or list of arrays of any shapes (H, W)

        Returns
        -------
        z : ndarray, shape (n, codebook_size)
            Each row sums to 1.
        """
        check_is_fitted(self)
        return np.stack(self._map(lambda mask: self._describe(mask).z, _checked(masks)))

    def describe(self, masks: Masks) -> list[Description]:
        """Describe masks with the steps in between, for those who want to look at them."""
        check_is_fitted(self)
        return self._map(self._describe, _checked(masks))

    def get_feature_names_out(self, input_features: object = None) -> NDArray[np.object_]:
        """Name the bins of the histogram."""
        check_is_fitted(self)
        return np.array([f"centre{k}" for k in range(len(self.codebook_))], dtype=object)

    def state(self) -> dict[str, Any]:
        """Give parameters and what was learnt, as arrays and numbers."""
        check_is_fitted(self)
        parameters = {k: v for k, v in self.get_params().items() if v is not None}
        return {**parameters, "codebook_": self.codebook_, "vote_width_": self.vote_width_}

    @classmethod
    def from_state(cls, state: dict[str, Any]) -> ShapeContextHistogram:
        """Restore what `state` gave."""
        learnt = {k: v for k, v in state.items() if k.endswith("_")}
        histogram = cls(**{k: np.asarray(v).item() for k, v in state.items() if k not in learnt})
        histogram.codebook_ = np.asarray(learnt["codebook_"], dtype=np.float32)
        histogram.vote_width_ = float(learnt["vote_width_"])
        return histogram

    def _describe(self, mask: NDArray[np.uint8]) -> Description:
        points, contexts = self._contexts(mask)
        distances = squared_distances(contexts, self.codebook_)
        voters = min(self.voters, len(self.codebook_))
        z = soft_votes(distances, voters, max(self.vote_width_, 1e-9))
        return Description(points, contexts, distances.argmin(axis=1), z)

    def _contexts(self, mask: NDArray[np.uint8]) -> tuple[NDArray[np.int32], NDArray[np.float32]]:
        pixels, lengths = boundary_pixels(mask)
        points = pixels[spaced_indices(pixels, lengths, self.edge_points)]
        size = np.sqrt(pixels.var(axis=0).sum())
        reach = max(self.radius * size, 1.0)  # a single pixel still has a neighbourhood
        bounds = ring_bounds(reach, self.inner_radius * reach, self.radial_bins)
        # Tables come in a few sizes, so that most masks share one.
        sectors = _table(64 * (int(reach) // 64 + 1), self.angular_bins)
        return points, shape_contexts(pixels, points, bounds, sectors, self.angular_bins)

    def _map(self, function: Any, masks: list[NDArray[np.uint8]]) -> list[Any]:
        threads = min(self.n_jobs or cpu_count() or 1, len(masks))
        if threads == 1:
            return [function(mask) for mask in masks]
        with ThreadPoolExecutor(threads) as pool:
            return list(pool.map(function, masks))

    def _check_parameters(self) -> None:
        for name in ("edge_points", "angular_bins", "radial_bins", "codebook_size", "voters"):
            if getattr(self, name) < 1:
                raise InputError(f"{name} must be at least 1, not {getattr(self, name)}")
        for name in ("radius", "vote_width"):
            if getattr(self, name) <= 0:
                raise InputError(f"{name} must be positive, not {getattr(self, name)}")
        if not 0 < self.inner_radius < 1:
            raise InputError(f"inner_radius must be between 0 and 1, not {self.inner_radius}")


def _checked(masks: Masks) -> list[NDArray[np.uint8]]:
    if isinstance(masks, np.ndarray) and masks.ndim != 3:
        raise InputError(f"masks have shape {masks.shape}: expected (n, height, width)")
    checked = [as_mask(mask, index) for index, mask in enumerate(masks)]
    if not checked:
        raise InputError("there are no masks")
    return checked
