"""How a mixture of regressors is fitted: from clusters of some examples, by EM to all."""

from __future__ import annotations

from collections.abc import Callable
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.errors import InputError
from silpose.core.random_states import RandomState, seed_of
from silpose.core.types import Array
from silpose.regression.mixture.em import expectation_maximisation
from silpose.regression.mixture.experts import Experts, Prior
from silpose.regression.mixture.local_clusters import local_clusters
from silpose.regression.mixture.prediction import MixturePredictions
from silpose.regression.mixture.reduced_examples import ReducedArrays, ReducedBlocks
from silpose.regression.mixture.reduction import PoseDirections
from silpose.regression.regressor import Regressor
from silpose.regression.scales import units_of


class MixtureFitting(MixturePredictions):
    """What `fit` and `fit_blocks` of `MixtureOfRegressors` have in common."""

    clusters: int
    dimensions: int
    damping: float
    shared: Regressor | None
    smallest: int
    units: ArrayLike | None
    hellinger: bool
    max_iter: int
    tol: float
    random_state: RandomState

    def _check_clusters(self, count: int) -> None:
        if self.clusters > count:
            raise InputError(
                f"clusters must be at most the number of examples, n_samples = {count}, "
                f"not {self.clusters}"
            )

    def _fit(
        self,
        inputs: Array,
        outputs: Array,
        all_of: Callable[[Array, Array], ReducedArrays | ReducedBlocks],
    ) -> Self:
        """Start from some examples, or all; then fit to all, which are made from ψ and poses."""
        poses = (outputs - self.mean_) / self.scale_
        seed = seed_of(self.random_state)
        reduction = PoseDirections(self.dimensions, hellinger=self.hellinger, random_state=seed)
        compared = poses
        if self.units is not None:  # the geometric mean of both scales
            compared = poses * np.sqrt(self.scale_ / units_of(self.units, len(self.scale_)))
        self.reduction_ = reduction.fit(inputs, compared)
        psi = self.reduction_.transform(inputs)
        labels = local_clusters(psi, compared, self.clusters, self.smallest, seed)
        prior = Prior.typical(psi, poses, labels, self.damping, self.floor)
        experts = Experts.fit(psi, poses, np.eye(labels.max() + 1)[labels], prior)
        examples = all_of(psi, poses)
        self.experts_, self.objective_, self.pruned_ = expectation_maximisation(
            examples, experts, prior, 0.5 * self.smallest, self.max_iter, self.tol
        )
        self.n_iter_ = len(self.objective_)
        self.shared_ = None
        if self.shared is not None:
            self.shared_ = examples.share(self.shared, self.experts_)
        widest = self.experts_.spreads.max(axis=0)
        mean, variance = examples.moments()
        self.background_ = np.stack([mean, np.maximum(variance, widest)])
        return self
