"""The histogram of shape contexts: one vector z per silhouette."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
from numbers import Integral, Real
from os import cpu_count
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, TransformerMixin
from sklearn.utils.validation import check_is_fitted

from silpose.core.errors import InputError
from silpose.descriptor.boundary import Pixels, as_mask, boundary_pixels, extent, spaced_indices
from silpose.descriptor.codebook import METHODS, learn_codebook, typical_distance
from silpose.descriptor.shape_context import ring_bounds, sector_table, shape_contexts
from silpose.descriptor.voting import soft_votes

Masks = NDArray[Any] | Sequence[ArrayLike]
T = TypeVar("T")

NORMALISATIONS = ("sum", "mean", "none")
COUNTS = {"edge_points", "angular_bins", "radial_bins", "codebook_size", "voters", "max_contexts"}
FACTORS = {"spacing", "radius", "vote_width"}
OPTIONAL = {"edge_points", "spacing", "voters"}  # what may be None

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
    rings : ndarray, shape (radial_bins,)
        Outer radii of the contexts' rings, pixels.
    """

    points: NDArray[np.int32]
    contexts: NDArray[np.float32]
    nearest: NDArray[np.int32]
    z: NDArray[np.float64]
    rings: NDArray[np.float64]


class ShapeContextHistogram(TransformerMixin, BaseEstimator):
    """Histogram of shape contexts, softly voted into a learnt codebook (section II-A).

    Parameters
    ----------
    edge_points : int or None
        Regularly spaced points on the boundary at which contexts are taken; None takes one at
        every boundary pixel.
    spacing : float or None
        Distance of the edge points along the boundary, relative to the silhouette's size; takes
        the place of `edge_points`.
    angular_bins, radial_bins : int
        Of a context; the rings grow by equal factors.
    closing : float
        Gaps, notches and holes narrower than this share of the silhouette's height or width,
        whichever is larger, are filled before the boundary is followed: the false edges of a thin
        occluder, or of holes, would otherwise be as many as the person's own. 0 fills nothing.
    radius : float
        Reach of a context, relative to the silhouette's size, which is the root mean square
        distance of its boundary from its centre: 0.3 of a standing person's height.
    inner_radius : float
        Outer radius of the innermost ring, relative to `radius`.
    codebook_size : int
        Number of centres.
    codebook_method : {"kmeans", "kmeans_seeds", "random", "farthest"}
        How they are chosen: k-means, the seeds of k-means++ as they are, contexts drawn evenly, or
        each the context farthest from all before.
    voters : int or None
        Centres that each context votes into; None is all of them, so that no bin is ever zero.
    vote_width : float
        Standard deviation of a vote, relative to the typical distance of a training context
        to its nearest centre.
    normalisation : {"sum", "mean", "none"}
        Whether a histogram sums to 1, has mean 1, or counts edge points.
    max_contexts : int
        At most so many contexts, drawn evenly from all masks, are what centres are chosen from.
    random_state : int or None
    n_jobs : int or None
        Threads; None is one per processor. The result does not depend on it.

    Attributes
    ----------
    codebook_ : ndarray, shape (codebook_size, radial_bins * angular_bins)
        Neighbours are alike: the centres go round a circle, the last is next to the first.
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
        edge_points: int | None = 200,
        spacing: float | None = None,
        closing: float = 0.0,
        angular_bins: int = 12,
        radial_bins: int = 5,
        radius: float = 0.45,
        inner_radius: float = 0.1,
        codebook_size: int = 100,
        codebook_method: str = "kmeans",
        voters: int | None = 8,
        vote_width: float = 0.7,
        normalisation: str = "sum",
        max_contexts: int = 50_000,
        random_state: int | None = 0,
        n_jobs: int | None = None,
    ) -> None:
        self.edge_points = edge_points
        self.spacing = spacing
        self.closing = closing
        self.angular_bins = angular_bins
        self.radial_bins = radial_bins
        self.radius = radius
        self.inner_radius = inner_radius
        self.codebook_size = codebook_size
        self.codebook_method = codebook_method
        self.voters = voters
        self.vote_width = vote_width
        self.normalisation = normalisation
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
        _check_stack(masks)
        # Contexts of all masks, but not all contexts: as many from each, at random points.
        share = max(1, self.max_contexts // len(masks))
        seeds = np.random.SeedSequence(self.random_state).spawn(len(masks))

        def some_contexts(index: int) -> NDArray[np.float32]:
            pixels, points = self._boundary(as_mask(masks[index], index))
            few = min(share, len(points))
            chosen = np.random.default_rng(seeds[index]).choice(len(points), few, replace=False)
            return self._contexts(pixels, points[chosen], self._rings(pixels))

        contexts = np.concatenate(self._map(some_contexts, len(masks)))
        self.codebook_ = learn_codebook(
            contexts, self.codebook_size, self.codebook_method, self.random_state
        )
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
        """
        return np.stack([description.z for description in self.describe(masks)])

    def describe(self, masks: Masks) -> list[Description]:
        """Describe masks with the steps in between, for those who want to look at them."""
        check_is_fitted(self)
        _check_stack(masks)
        transposed = np.ascontiguousarray(self.codebook_.T)
        norms = np.einsum("kb,kb->k", self.codebook_, self.codebook_)
        voters = min(self.voters or len(norms), len(norms))
        width = max(self.vote_width_, 1e-9)

        def description(index: int) -> Description:
            pixels, points = self._boundary(as_mask(masks[index], index))
            rings = self._rings(pixels)
            contexts = self._contexts(pixels, points, rings)
            votes, nearest = soft_votes(contexts, transposed, norms, voters, width)
            z = self._normalised(votes, len(points))
            return Description(points, contexts, nearest, z, rings)

        return self._map(description, len(masks))

    def get_feature_names_out(self, input_features: object = None) -> NDArray[np.object_]:
        """Name the bins of the histogram."""
        check_is_fitted(self)
        return np.array([f"centre{k}" for k in range(len(self.codebook_))], dtype=object)

    def to_arrays(self) -> dict[str, Any]:
        """Give parameters and what was learnt, as arrays and numbers."""
        check_is_fitted(self)
        # An .npz holds no None: what is None is left out, what is said explicitly comes back.
        parameters = {k: [] if v is None else v for k, v in self.get_params().items()}
        return {**parameters, "codebook_": self.codebook_, "vote_width_": self.vote_width_}

    @classmethod
    def from_arrays(cls, state: dict[str, Any]) -> ShapeContextHistogram:
        """Restore what `state` gave."""
        learnt = {k: v for k, v in state.items() if k.endswith("_")}
        plain = {k: np.asarray(v) for k, v in state.items() if k not in learnt}
        parameters: dict[str, Any] = {k: v.item() if v.size else None for k, v in plain.items()}
        histogram = cls(**parameters)
        histogram.codebook_ = np.asarray(learnt["codebook_"], dtype=np.float32)
        histogram.vote_width_ = float(learnt["vote_width_"])
        return histogram

    def _boundary(self, mask: NDArray[np.uint8]) -> tuple[Pixels, Pixels]:
        """All boundary pixels (N, 2), and the edge points (P, 2) among them."""
        pixels, lengths = boundary_pixels(mask, self.closing)
        if self.spacing is not None:
            step = self.spacing * max(extent(pixels), 1.0)
            return pixels, pixels[spaced_indices(pixels, lengths, 0, step)]
        if self.edge_points is not None:
            return pixels, pixels[spaced_indices(pixels, lengths, self.edge_points, 0.0)]
        return pixels, pixels

    def _rings(self, pixels: Pixels) -> NDArray[np.float64]:
        reach = max(self.radius * extent(pixels), 1.0)  # a single pixel still has a neighbourhood
        return ring_bounds(reach, self.inner_radius * reach, self.radial_bins)

    def _contexts(
        self, pixels: Pixels, points: Pixels, rings: NDArray[np.float64]
    ) -> NDArray[np.float32]:
        # Tables come in a few sizes, so that most masks share one.
        sectors = _table(64 * (int(rings[-1]) // 64 + 1), self.angular_bins)
        return shape_contexts(pixels, points, rings, sectors, self.angular_bins)

    def _normalised(self, votes: NDArray[np.float64], points: int) -> NDArray[np.float64]:
        if self.normalisation == "none":
            return votes
        return votes * ((len(votes) if self.normalisation == "mean" else 1) / points)

    def _map(self, function: Callable[[int], T], count: int) -> list[T]:
        """Call a function with every mask's index, in blocks on several threads."""
        threads = min(self.n_jobs or cpu_count() or 1, count)
        if threads == 1:
            return [function(index) for index in range(count)]
        blocks = np.array_split(np.arange(count), min(8 * threads, count))
        with ThreadPoolExecutor(threads) as pool:
            done = pool.map(lambda block: [function(int(index)) for index in block], blocks)
            return [result for block in done for result in block]

    def _check_parameters(self) -> None:
        given = {k: v for k, v in self.get_params().items() if v is not None or k not in OPTIONAL}
        for name in COUNTS & given.keys():
            if not (isinstance(given[name], Integral) and given[name] >= 1):
                raise InputError(f"{name} must be at least 1, not {given[name]}")
        for name in FACTORS & given.keys():
            if not (isinstance(given[name], Real) and 0 < given[name] < np.inf):
                raise InputError(f"{name} must be positive, not {given[name]}")
        if not (isinstance(self.closing, Real) and 0 <= self.closing < 1):
            raise InputError(f"closing must be at least 0 and below 1, not {self.closing}")
        if not 0 < self.inner_radius < 1:
            raise InputError(f"inner_radius must be between 0 and 1, not {self.inner_radius}")
        for name, known in (("codebook_method", METHODS), ("normalisation", NORMALISATIONS)):
            if (value := getattr(self, name)) not in known:
                raise InputError(f"there is no {name}={value}; there are {', '.join(known)}")


def _check_stack(masks: Masks) -> None:
    if isinstance(masks, np.ndarray) and masks.ndim != 3:
        raise InputError(f"masks have shape {masks.shape}: expected (n, height, width)")
    if not len(masks):
        raise InputError("there are no masks")
