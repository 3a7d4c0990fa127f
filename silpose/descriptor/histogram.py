"""The histogram of shape contexts: one vector z per silhouette."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from sklearn.base import BaseEstimator, TransformerMixin
from sklearn.utils.validation import check_is_fitted

from silpose.core.parallel import thread_map
from silpose.core.parameters import check_parameters
from silpose.core.random_states import RandomState, seed_of
from silpose.core.serialisation import State, arrays_of, estimator_from
from silpose.core.types import Array, Array32
from silpose.descriptor.boundary import Masks, as_mask, stack_of
from silpose.descriptor.codebook import learn_codebook, typical_distance
from silpose.descriptor.constraints import CONSTRAINTS
from silpose.descriptor.description import Description, EdgeContexts
from silpose.descriptor.voting import soft_votes

_FITTED = ("codebook_", "vote_width_")


class ShapeContextHistogram(TransformerMixin, BaseEstimator):
    """Histogram of shape contexts, softly voted into a learnt codebook.

    Parameters
    ----------
    boundary : {"subpixel", "open", "pixels"}, default="subpixel"
        Where the boundary is: on a smooth curve between the pixels, so that a person has much the
        same histogram at any resolution; ``"open"`` the same, but nowhere along an edge of the
        image that cuts the person; or ``"pixels"``, on the outermost pixels themselves, as of
        models that were saved before there was a choice.
    edge_points : int or None, default=200
        Number of regularly spaced points on the boundary at which contexts are computed; None
        computes one at every point of the boundary: at every pixel, or 56 to a length that equals
        the silhouette's size.
    spacing : float or None, default=None
        Distance of the edge points along the boundary, relative to the silhouette's size; replaces
        `edge_points`.
    closing : float, default=0.0
        Gaps, notches and holes narrower than this share of the silhouette's height or width,
        whichever is larger, are filled before the boundary is followed. Otherwise the false edges
        of a thin occluder, or of holes, can be as many as the person's own.
    angular_bins : int, default=12
        Sectors of a context.
    radial_bins : int, default=5
        Rings of a context, whose radii grow by equal factors.
    radius : float, default=0.45
        Outer radius of a context, relative to the silhouette's size, which is the root mean square
        distance of its boundary from its centre: 0.3 of a standing person's height.
    inner_radius : float, default=0.1
        Outer radius of the innermost ring, relative to `radius`.
    codebook_size : int, default=100
        Number of centres.
    codebook_method : {"kmeans", "kmeans_seeds", "random", "farthest"}, default="kmeans"
        Choice of the centres: k-means, the seeds of k-means++, contexts drawn evenly, or each the
        context that is farthest from all before.
    voters : int or None, default=8
        Number of centres that each context votes into; None is all of them, so that no bin is ever
        zero.
    vote_width : float, default=0.7
        Standard deviation of a vote, relative to the typical distance of a training context
        to its nearest centre.
    normalisation : {"sum", "mean", "none"}, default="sum"
        Whether a histogram sums to 1, has mean 1, or counts edge points.
    max_contexts : int, default=50_000
        Largest number of contexts, drawn evenly from all masks, that centres are chosen from.
    random_state : int, RandomState, Generator or None, default=0
        Seed of the contexts that are drawn, and of the codebook.
    n_jobs : int or None, default=None
        Number of threads, which does not change the result; None or -1 is one per
        processor.

    Attributes
    ----------
    codebook_ : ndarray, shape (codebook_size, radial_bins * angular_bins)
        Centres, in a circular order in which neighbours are similar.
    vote_width_ : float
        Standard deviation of a vote, in units of contexts.

    See Also
    --------
    HuMoments, AlignedMask : Simpler descriptors, for comparison.

    References
    ----------
    Section II-A of the paper.

    Examples
    --------
    >>> masks = [[[0, 1, 1], [0, 1, 0], [1, 1, 0]], [[1, 1, 1], [0, 1, 0], [0, 1, 0]]]
    >>> ShapeContextHistogram(edge_points=6, codebook_size=4).fit_transform(masks).shape
    (2, 4)
    """

    constraints = CONSTRAINTS

    def __init__(
        self,
        *,
        boundary: str = "subpixel",
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
        random_state: RandomState = 0,
        n_jobs: int | None = None,
    ) -> None:
        self.boundary = boundary
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
        y : object, optional
            Ignored.

        Returns
        -------
        self : ShapeContextHistogram

        Raises
        ------
        InputError
            If a parameter or a mask cannot be used, or there are fewer contexts than centres.
        """
        check_parameters(self)
        masks = stack_of(masks)
        extractor = EdgeContexts.of(self)
        # The same number of contexts from every mask, at random points.
        share = max(1, self.max_contexts // len(masks))
        seed = seed_of(self.random_state)
        seeds = np.random.SeedSequence(seed).spawn(len(masks))

        def some_contexts(index: int) -> Array32:
            edge = extractor.edge(as_mask(masks[index], index))
            few, points = min(share, len(edge.chosen)), len(edge.chosen)
            some = np.random.default_rng(seeds[index]).choice(points, few, replace=False)
            return extractor.contexts(edge, edge.chosen[some], extractor.rings(edge))

        contexts = np.concatenate(thread_map(some_contexts, len(masks), self.n_jobs))
        self.codebook_ = learn_codebook(contexts, self.codebook_size, self.codebook_method, seed)
        self.vote_width_ = self.vote_width * typical_distance(contexts, self.codebook_)
        return self

    def transform(self, masks: Masks) -> Array:
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
        """Describe masks as `transform` does, and keep the intermediate results.

        Parameters
        ----------
        masks : array-like, shape (n, H, W), or list of arrays of any shapes (H, W)

        Returns
        -------
        descriptions : list of Description

        Raises
        ------
        InputError
            If a mask cannot be used; it is named by its index.
        """
        check_is_fitted(self)
        masks = stack_of(masks)
        extractor = EdgeContexts.of(self)
        transposed = np.ascontiguousarray(self.codebook_.T)
        norms = np.einsum("kb,kb->k", self.codebook_, self.codebook_)
        voters = min(self.voters or len(norms), len(norms))
        width = max(self.vote_width_, 1e-9)

        def description(index: int) -> Description:
            edge = extractor.edge(as_mask(masks[index], index))
            rings = extractor.rings(edge)
            contexts = extractor.contexts(edge, edge.chosen, rings)
            votes, nearest = soft_votes(contexts, transposed, norms, voters, width)
            z = self._normalised(votes, len(edge.points))
            return Description(edge.points, contexts, nearest, z, edge.unit * rings)

        return thread_map(description, len(masks), self.n_jobs)

    def get_feature_names_out(self, input_features: object = None) -> NDArray[np.object_]:
        """Names of the histogram's bins, ``centre0``, ``centre1`` and so on."""
        check_is_fitted(self)
        return np.array([f"centre{k}" for k in range(len(self.codebook_))], dtype=object)

    def to_arrays(self) -> State:
        """Parameters and fitted attributes, as `silpose.core.serialisation` defines them."""
        check_is_fitted(self)
        return arrays_of(self, _FITTED)

    @classmethod
    def from_arrays(cls, state: State) -> ShapeContextHistogram:
        """Restore an estimator from what `to_arrays` returned."""
        # What was saved before there was a choice of boundaries followed the pixels.
        return estimator_from(cls, {"boundary": "pixels"} | state, _FITTED)

    def _normalised(self, votes: Array, points: int) -> Array:
        if self.normalisation == "none":
            return votes
        return votes * ((len(votes) if self.normalisation == "mean" else 1) / points)
