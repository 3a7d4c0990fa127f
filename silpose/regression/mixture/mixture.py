"""Mixture of regressors: several poses for one silhouette, each with its probability (Eq. 11).

The paper's text breaks off after that equation. The method here follows its idea: a Gaussian gate
on a reduced input, components that start where locality of the input and connectivity of the
output show that one silhouette means several poses, and EM.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar, Literal

from numpy.typing import ArrayLike
from sklearn.utils import Tags
from sklearn.utils.validation import validate_data

from silpose.core.parameters import Constraints, check_parameters
from silpose.core.random_states import RandomState
from silpose.core.types import Array
from silpose.regression.blocks import Blocks
from silpose.regression.centres import evenly_spaced
from silpose.regression.examples import StreamedExamples
from silpose.regression.mixture.constraints import CONSTRAINTS
from silpose.regression.mixture.fitting import MixtureFitting
from silpose.regression.mixture.local_clusters import warn_of_few
from silpose.regression.mixture.reduced_examples import ReducedArrays, ReducedBlocks
from silpose.regression.mixture.shared_regressor import SharedFit
from silpose.regression.regressor import Regressor
from silpose.regression.scales import scales_of

_SAMPLE = 10_000  # examples of blocks from which the reduction and the first clusters are found


class MixtureOfRegressors(MixtureFitting):
    """p(x|z) = Σ_k π_k(z) N(A_k ψ(z) + b_k, Λ_k) (Eq. 11), Λ_k diagonal.

    The gate π_k(z) is the share of π_k N(ψ; μ_k, S_k) among all components and a background
    component. That one's gate is as wide as all training examples, so that it takes over where
    nothing like z was seen; its density has the mean and the variance of all poses.

    Parameters
    ----------
    clusters : int, default=60
        Number of clusters of inputs, before they are split by connectivity in pose space. Less
        than `smallest` examples for each bring a warning, as do less than 200 without `shared`.
    dimensions : int, default=90
        Largest dimension of the reduced input ψ, and a third of the training examples at most.
    damping : float, default=30.0
        λ of each component's ridge regression, outputs being at unit variance.
    temperature : float, default=8.0
        Divisor of the gates' log densities in predictions. Unseen silhouettes lie further out
        than those in training, and are unusual in several columns of ψ at once.
    noise_width : float, default=1.0
        Factor of Λ_k in predictions: likewise poses.
    outlier_probability : float, default=0.01
        Prior probability that none of the components is right.
    floor : float, default=0.1
        Least standard deviation of an output, in units of its own in training.
    agreement : float, default=1.0
        Components whose means differ by less are one mode: mean over outputs of the squared
        difference, in units of the sum of their training variances.
    calibration_exponent : float, default=1.0
        Exponent of modes' weights, which calibrates them: components that just fail to agree
        take weight from each other, and many weak ones from a strong one.
    point_estimate : {"mode", "mean"}, default="mode"
        What `predict` returns: the most probable mode, or the mean of the mixture.
    shared : Regressor or None, default=None
        A regressor that is fitted to all examples. Components' means move towards its estimate,
        in columns in which its error on the component's examples is small.
    shared_width : float, default=8.0
        Factor of the variance of its training error: the larger, the lower its weight.
    shared_temperature : float, default=128.0
        Divisor of the log densities by which the shared regressor's estimate changes components'
        weights: its errors in one column come with errors in others.
    smallest : int, default=5
        Least number of examples of a component.
    units : array-like, shape (D,), or None, default=None
        One unit of error in each output. For the initial clusters, outputs are compared on a
        scale halfway between their units and their standard deviations; without, on the latter.
    hellinger : bool, default=True
        Whether to take square roots of the inputs first; they must not be negative then.
    max_iter : int, default=10
        Largest number of rounds of EM.
    tol : float, default=1e-2
        EM stops once a round adds less than this to the log-likelihood per example.
    random_state : int, RandomState, Generator or None, default=0
        Seed or source of random numbers.

    Attributes
    ----------
    experts_ : Experts
    reduction_ : PoseDirections
    shared_ : SharedRegressor or None
    objective_ : list of float
        Penalised log-likelihood per example, which EM maximises, before each round.
    n_iter_ : int
        Rounds of EM.
    pruned_ : list of int
        Rounds before which small components were pruned; only there may the objective fall.

    See Also
    --------
    choose_mixture : Chooses parameters by held-out likelihood.
    """

    constraints: ClassVar[Constraints] = CONSTRAINTS

    def __init__(
        self,
        clusters: int = 60,
        *,
        dimensions: int = 90,
        damping: float = 30.0,
        temperature: float = 8.0,
        noise_width: float = 1.0,
        outlier_probability: float = 0.01,
        floor: float = 0.1,
        agreement: float = 1.0,
        calibration_exponent: float = 1.0,
        point_estimate: Literal["mode", "mean"] = "mode",
        shared: Regressor | None = None,
        shared_width: float = 8.0,
        shared_temperature: float = 128.0,
        smallest: int = 5,
        units: ArrayLike | None = None,
        hellinger: bool = True,
        max_iter: int = 10,
        tol: float = 1e-2,
        random_state: RandomState = 0,
    ) -> None:
        self.clusters = clusters
        self.dimensions = dimensions
        self.damping = damping
        self.temperature = temperature
        self.noise_width = noise_width
        self.outlier_probability = outlier_probability
        self.floor = floor
        self.agreement = agreement
        self.calibration_exponent = calibration_exponent
        self.point_estimate = point_estimate
        self.shared = shared
        self.shared_width = shared_width
        self.shared_temperature = shared_temperature
        self.smallest = smallest
        self.units = units
        self.hellinger = hellinger
        self.max_iter = max_iter
        self.tol = tol
        self.random_state = random_state

    def fit(self, X: ArrayLike, y: ArrayLike) -> MixtureOfRegressors:
        """Fit by EM.

        Parameters
        ----------
        X : array-like, shape (n, d)
            Inputs: descriptors z.
        y : array-like, shape (n, D) or (n,)
            Outputs: poses x.

        Raises
        ------
        InputError
            If a parameter or an input cannot be used.
        """
        return self.fit_with(X, y, SharedFit.of)

    def fit_with(
        self, X: ArrayLike, y: ArrayLike, fit_shared: Callable[[Regressor, Array, Array], SharedFit]
    ) -> MixtureOfRegressors:
        """Fit as `fit` does, where several mixtures of the same examples have one shared regressor.

        Parameters
        ----------
        X : array-like, shape (n, d)
        y : array-like, shape (n, D) or (n,)
        fit_shared : callable
            From `shared`, inputs and standardised poses to what is `SharedFit.of` them.
        """
        check_parameters(self)
        inputs, outputs = validate_data(self, X, y, dtype=float, multi_output=True, y_numeric=True)
        self._check_clusters(len(inputs))
        warn_of_few(len(inputs), self.clusters, self.smallest, self.shared is None)
        self._single = outputs.ndim == 1
        outputs = outputs.reshape(len(outputs), -1).astype(float)
        self.mean_, self.scale_, self.varies_ = scales_of(outputs)

        def whole(psi: Array, poses: Array) -> ReducedArrays:
            return ReducedArrays(inputs, psi, poses, fit_shared)

        return self._fit(inputs, outputs, whole)

    def fit_blocks(self, blocks: Blocks) -> MixtureOfRegressors:
        """Fit to examples that need not be in memory at once.

        Memory depends on the number of components, not on that of the examples. The reduction of
        inputs and the clusters that EM starts from are those of an even sample of at most 10,000
        examples; EM, the shared regressor and the background go over all. So the result is that
        of `fit`, to rounding, for up to 10,000 examples; for more, `fit` takes its start from all
        of them. Blocks are read several times in every round, by the workers of
        `silpose.core.parallel`.

        Parameters
        ----------
        blocks : sequence
            As of `Regressor.fit_blocks`.

        Raises
        ------
        InputError
            If a parameter or a block cannot be used; the block is named by its index.
        """
        check_parameters(self)
        survey = StreamedExamples(blocks, self.hellinger)
        whole = survey.whole
        self._check_clusters(whole.count)
        warn_of_few(whole.count, self.clusters, self.smallest, self.shared is None)
        self._single = False
        self.n_features_in_ = len(whole.mean_f)
        self.mean_, (self.scale_, self.varies_) = whole.mean_y, whole.scales
        inputs, outputs = survey.read(evenly_spaced(whole.count, _SAMPLE))

        def streamed(psi: Array, poses: Array) -> ReducedBlocks:
            return ReducedBlocks(blocks, whole.count, self.reduction_, self.mean_, self.scale_)

        return self._fit(inputs, outputs, streamed)

    def __sklearn_tags__(self) -> Tags:
        tags = super().__sklearn_tags__()
        tags.input_tags.positive_only = self.hellinger
        tags.regressor_tags.poor_score = True  # `score` is a log-likelihood, and no R²
        return tags
