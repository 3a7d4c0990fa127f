"""Mixture of regressors: several poses for one silhouette, each with its probability (Eq. 11).

The paper's text breaks off after that equation. What is done here in its spirit: a Gaussian gate
on a reduced input, components that start where locality of the input and connectivity of the
output say that one silhouette means several poses, and EM.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, MultiOutputMixin, RegressorMixin
from sklearn.utils import Tags
from sklearn.utils.validation import check_is_fitted, validate_data

from silpose.core.errors import InputError
from silpose.regression.mixture.density import ConditionalDensity, MixtureInput
from silpose.regression.mixture.experts import Prior, expectation_maximisation
from silpose.regression.mixture.local_clusters import local_clusters
from silpose.regression.mixture.modes import sharpened
from silpose.regression.mixture.reduction import PoseDirections
from silpose.regression.mixture.shared_regressor import SharedRegressor
from silpose.regression.regressor import Regressor

Array = NDArray[np.float64]

_MODES = 8  # among which weights are sharpened
_POSITIVE = (
    "clusters", "dimensions", "damping", "temperature", "noise_width", "floor", "agreement",
    "sharpness", "shared_width", "shared_temperature", "smallest", "max_iter",
)  # fmt: skip
ANSWERS = ("mode", "mean")


class MixtureOfRegressors(MultiOutputMixin, RegressorMixin, BaseEstimator):
    """p(x|z) = Σ_k π_k(z) N(A_k ψ(z) + b_k, Λ_k) (Eq. 11), Λ_k diagonal.

    The gate π_k(z) is the share of π_k N(ψ; μ_k, S_k) among all components and one that is as
    wide as all training examples, which takes over where nothing like z was seen. Its answer is
    anything: the mean of all poses with their variance.

    Parameters
    ----------
    clusters : int
        Of inputs, before they are split by connectivity in pose space.
    dimensions : int
        Of the reduced input ψ.
    damping : float
        λ of each component's ridge regression, outputs being at unit variance.
    temperature : float
        By which the gates' log densities are divided when they answer. Unseen silhouettes lie
        further out than those that trained, and what is unusual in one column of ψ is in others.
    noise_width : float
        Factor of Λ_k when they answer: likewise poses.
    doubt : float
        Probability, before anything is seen, that none of the components is right.
    floor : float
        Least standard deviation of an output, in its own standard deviations.
    agreement : float
        Components whose means differ by less are one mode: mean over outputs of the squared
        difference, in units of the sum of their training variances.
    sharpness : float
        Exponent of modes' weights, which calibrates them: components that just fail to agree
        take weight from each other, and many weak ones from a strong one.
    answer : {"mode", "mean"}
        What `predict` gives: the most probable mode, or the mean of the mixture.
    shared : Regressor, optional
        Fitted to all examples; a component's answers move towards its, in columns in which it
        errs little on the component's examples.
    shared_width : float
        Factor of the variance of its error in training: the larger, the less it is heeded.
    shared_temperature : float
        By which log densities are divided as which the shared regressor's estimate changes
        components' weights: its errors in one column come with errors in others.
    smallest : int
        Examples that a component wants, at least.
    units : array-like, shape (D,), or None
        What one unit of error is in each output. For the initial clusters outputs compare on a
        scale halfway between their units and their standard deviations; without, on the latter.
    hellinger : bool
        Whether to take square roots of the inputs first.
    max_iter, tol : int, float
        Of EM; it stops once a round adds less than `tol` per example.
    random_state : int or None

    Attributes
    ----------
    experts_ : Experts
    shared_ : SharedRegressor or None
    objective_ : list of float
        What EM maximises, penalised log-likelihood per example, before each round.
    n_iter_ : int
        Rounds of EM.
    pruned_ : list of int
        Rounds before which starved components were taken out; only there may it fall.
    """

    def __init__(
        self,
        clusters: int = 60,
        dimensions: int = 90,
        damping: float = 30.0,
        temperature: float = 8.0,
        noise_width: float = 1.0,
        doubt: float = 0.01,
        floor: float = 0.1,
        agreement: float = 1.0,
        sharpness: float = 1.0,
        answer: str = "mode",
        shared: Regressor | None = None,
        shared_width: float = 8.0,
        shared_temperature: float = 128.0,
        smallest: int = 5,
        units: ArrayLike | None = None,
        hellinger: bool = False,
        max_iter: int = 10,
        tol: float = 1e-2,
        random_state: int | None = 0,
    ) -> None:
        self.clusters = clusters
        self.dimensions = dimensions
        self.damping = damping
        self.temperature = temperature
        self.noise_width = noise_width
        self.doubt = doubt
        self.floor = floor
        self.agreement = agreement
        self.sharpness = sharpness
        self.answer = answer
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
        """
        inputs, outputs = validate_data(self, X, y, dtype=float, multi_output=True, y_numeric=True)
        self._check(inputs)
        self._single = outputs.ndim == 1
        outputs = outputs.reshape(len(outputs), -1).astype(float)
        self.mean_, deviation = outputs.mean(axis=0), outputs.std(axis=0)
        self.varies_ = deviation > 1e-10 * np.maximum(np.abs(self.mean_), 1)
        self.scale_ = np.where(self.varies_, deviation, 1.0)
        poses = (outputs - self.mean_) / self.scale_
        reduction = PoseDirections(
            self.dimensions, hellinger=self.hellinger, random_state=self.random_state
        )
        compared = poses
        if self.units is not None:  # the geometric mean of both
            compared = poses * np.sqrt(self.scale_ / np.asarray(self.units, dtype=float))
        self.reduction_ = reduction.fit(inputs, compared)
        psi = self.reduction_.transform(inputs)
        labels = local_clusters(psi, compared, self.clusters, self.smallest, self.random_state)
        prior = Prior.typical(psi, poses, labels, self.damping, self.floor)
        self.experts_, self.objective_, self.pruned_ = expectation_maximisation(
            psi, poses, labels, prior, 0.5 * self.smallest, self.max_iter, self.tol
        )
        self.n_iter_ = len(self.objective_)
        self.shared_ = None
        if self.shared is not None:
            shares, _ = self.experts_.responsibilities(psi, poses, prior)
            self.shared_ = SharedRegressor.fit(self.shared, inputs, poses, shares)
        widest = self.experts_.spreads.max(axis=0)
        self.anywhere_ = np.stack([psi.mean(axis=0), np.maximum(psi.var(axis=0), widest)])
        return self

    def __sklearn_tags__(self) -> Tags:
        tags = super().__sklearn_tags__()
        tags.regressor_tags.poor_score = True  # `score` is a log-likelihood, and no R²
        return tags

    def _check(self, inputs: Array) -> None:
        for name in _POSITIVE:
            if not getattr(self, name) > 0:
                raise InputError(f"{name} must be positive, not {getattr(self, name)}")
        if self.clusters > len(inputs):
            raise InputError(
                f"{self.clusters} clusters want as many examples, and n_samples = {len(inputs)}: "
                "give more, or fewer clusters"
            )
        if not 0 <= self.doubt < 1:
            raise InputError(f"doubt is a probability below 1, not {self.doubt}")
        if self.answer not in ANSWERS:
            raise InputError(f"there is no answer '{self.answer}'; there are {', '.join(ANSWERS)}")
        if self.hellinger and inputs.min() < 0:
            raise InputError("square roots need histograms: negative inputs want hellinger=False")

    @property
    def components_(self) -> int:
        """Number of components, K."""
        return len(self.experts_.offsets)

    def predict(self, X: ArrayLike) -> Array:
        """Estimate outputs, shape (n, D): the most probable mode, or the mean of the mixture."""
        if self.answer == "mode":
            estimated = self.predict_modes(X, 1)[1][:, 0]
        else:
            estimated = self._density.mean(self._seen(X)) * self.scale_ + self.mean_
        return estimated[:, 0] if self._single else estimated

    def predict_modes(self, z: ArrayLike, k: int) -> tuple[Array, Array, Array]:
        """Give the k most probable modes, best first.

        Components that agree are one mode, at their weighted mean.

        Parameters
        ----------
        z : array-like, shape (n, d)
        k : int

        Returns
        -------
        weights : ndarray, shape (n, k)
            Probabilities. What is missing to 1 are further modes, and that none is right. Where
            there are less than k modes the rest has weight 0 and repeats the first.
        means, variances : ndarray, shape (n, k, D)
        """
        if k < 1:
            raise InputError(f"at least one mode is to be asked for, not {k}")
        several = max(k, _MODES)
        found = self._density.modes(self._seen(z), several, self.agreement)
        weights, means, variances = sharpened(found[0], self.sharpness), *found[1:]
        weights, means, variances = weights[:, :k], means[:, :k], variances[:, :k]
        return weights, means * self.scale_ + self.mean_, variances * self.scale_**2

    def answers(self, z: ArrayLike, least: float = 1e-6) -> tuple[Array, Array, Array]:
        """Give the components that may have an answer to one input.

        Components weigh as if all were equally frequent, without their π_k: a tracker adds what
        it expects itself.

        Parameters
        ----------
        z : array-like, shape (d,)
        least : float
            Weight below which a component has nothing to say.

        Returns
        -------
        log_weights : ndarray, shape (K',)
        means, variances : ndarray, shape (K', D)
            Last among them is the one that stands for none.
        """
        seen = self._seen(np.asarray(z, dtype=float)[None])
        log_weights, means, variances = self._density.answers(seen, least)
        return log_weights, means * self.scale_ + self.mean_, variances * self.scale_**2

    def variances(self) -> Array:
        """Diagonals of Λ_k, and the variance of anything, shape (K + 1, D)."""
        return self._density.variances() * self.scale_**2

    def sample(self, z: ArrayLike, count: int = 1, seed: int | None = None) -> Array:
        """Draw outputs from p(x|z), shape (n, count, D)."""
        drawn = self._density.sample(self._seen(z), count, np.random.default_rng(seed))
        return drawn * self.scale_ + self.mean_

    def log_likelihoods(self, z: ArrayLike, x: ArrayLike) -> Array:
        """Log p(x|z) of each example, shape (n,).

        Outputs are on the scale of their standard deviations in training, and those that are
        constant there are left out.
        """
        density, x = self._density, np.asarray(x, dtype=float)
        poses = (x.reshape(len(x), -1) - self.mean_) / self.scale_
        return density.log_likelihoods(self._seen(z), poses, self.varies_)

    @property
    def _density(self) -> ConditionalDensity:
        check_is_fitted(self)
        return ConditionalDensity(
            self.experts_, self.anywhere_, self.shared_, self.temperature, self.noise_width,
            self.shared_width, self.shared_temperature, self.doubt, self.floor,
        )  # fmt: skip

    def _seen(self, z: ArrayLike) -> MixtureInput:
        z = validate_data(self, z, dtype=float, reset=False)
        shared = None if self.shared_ is None else self.shared_.regressor.predict(z)
        return MixtureInput(self.reduction_.transform(z), shared)

    def score(self, X: ArrayLike, y: ArrayLike, sample_weight: ArrayLike | None = None) -> float:
        """Log-likelihood per example, of outputs at unit variance."""
        weights = None if sample_weight is None else np.asarray(sample_weight, dtype=float)
        return float(np.average(self.log_likelihoods(X, y), weights=weights))
