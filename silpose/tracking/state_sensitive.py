"""State-sensitive regression: pose from a predicted pose and a silhouette, Eqs. 9 and 10."""

from __future__ import annotations

from functools import cached_property
from math import ceil
from typing import ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike
from sklearn.base import BaseEstimator
from sklearn.neighbors import NearestNeighbors
from sklearn.utils.validation import check_is_fitted

from silpose.core.parameters import (
    FROM_0_TO_1,
    POSITIVE,
    POSITIVE_INTEGER,
    SEED,
    SHARE,
    Constraints,
    check_parameters,
)
from silpose.core.random_states import RandomState, generator_of
from silpose.core.serialisation import State, arrays_of, estimator_from
from silpose.core.types import Array, Examples, Indices
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.scales import scales_of
from silpose.regression.sparse import FirstBridges, sparsest_within
from silpose.tracking.distances import squared_distances
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.takes import checked_takes

_NEIGHBOURS = 10  # training poses whose scatter around a state is its local scatter
_FIRST_NU = 16.0  # of the path to a wanted sparsity
_FITTED = (
    "mean_", "scale_", "centres_x_", "centres_z_", "beta_x_", "beta_z_", "coef_", "intercept_",
    "kept_",
)  # fmt: skip


class StateSensitiveRegressor(BaseEstimator):
    """x̂ = C x̌ + Σ_k d_k K_x(x̌, x_k) K_z(z, z_k) (Eqs. 9, 10).

    Parameters
    ----------
    pose_width : float, default=1.0
        Factor of β_x, in units of 1 / (2 tr S), S being the scatter matrix of the standardised
        poses: the larger, the narrower the kernels.
    descriptor_width : float, default=2.0
        Factor of β_z, likewise for the square roots of descriptors.
    linear : float or None, default=None
        s of C = sI; None for the full matrix C.
    damping : float, default=0.1
        λ of the ridge regression.
    centres : int, default=2000
        Largest number of training examples, drawn by seed, that carry a kernel.
    keep_at_most : float or None, default=0.18
        Share of the kernels that an RVM keeps; None is ridge regression on all.
    random_state : int, RandomState, Generator or None, default=0
        Seed of the draw of centres.

    Attributes
    ----------
    centres_x_, centres_z_ : ndarray, shapes (k, D) and (k, d)
        Of the kernels kept: standardised poses, square roots of descriptors.
    beta_x_, beta_z_ : float
        β_x and β_z.
    coef_ : ndarray, shape (k, D) or (k + D, D)
        d_k above C, if that is a full matrix.
    intercept_ : ndarray, shape (D,)
    mean_, scale_ : ndarray, shape (D,)
        By which poses are standardised.
    kept_ : float
        Share of the kernels that are kept.
    """

    constraints: ClassVar[Constraints] = {
        "pose_width": POSITIVE,
        "descriptor_width": POSITIVE,
        "linear": FROM_0_TO_1.or_none(),
        "damping": POSITIVE,
        "centres": POSITIVE_INTEGER,
        "keep_at_most": SHARE.or_none(),
        "random_state": SEED,
    }

    def __init__(
        self,
        *,
        pose_width: float = 1.0,
        descriptor_width: float = 2.0,
        linear: float | None = None,
        damping: float = 0.1,
        centres: int = 2000,
        keep_at_most: float | None = 0.18,
        random_state: RandomState = 0,
    ) -> None:
        self.pose_width = pose_width
        self.descriptor_width = descriptor_width
        self.linear = linear
        self.damping = damping
        self.centres = centres
        self.keep_at_most = keep_at_most
        self.random_state = random_state

    def fit(self, predicted: ArrayLike, z: ArrayLike, x: ArrayLike) -> Self:
        """Fit C and d_k.

        Parameters
        ----------
        predicted : array-like, shape (n, D)
            Predictions x̌: see `observed_and_sampled`.
        z : array-like, shape (n, d)
            Descriptors.
        x : array-like, shape (n, D)
            True poses.

        Raises
        ------
        InputError
            If a parameter or an array cannot be used; take 0 is (z, x), take 1 (z, predicted).
        """
        check_parameters(self)
        (descriptors, poses), (_, states) = checked_takes([(z, x), (z, predicted)])
        self.mean_, self.scale_, _ = scales_of(poses)
        standard, state = self._standard(poses), self._standard(states)
        roots = np.sqrt(descriptors)
        random = generator_of(self.random_state)
        chosen = random.choice(len(poses), min(self.centres, len(poses)), replace=False)
        self.centres_x_, self.centres_z_ = standard[chosen], roots[chosen]
        self.beta_x_ = self.pose_width / max(2 * standard.var(axis=0).sum(), 1e-12)
        self.beta_z_ = self.descriptor_width / max(2 * roots.var(axis=0).sum(), 1e-12)
        self.__dict__.pop("_scaled_centres", None)  # of another fit
        kernels = _kernels(self._scaled(state, roots), self._scaled_centres)
        features = kernels if self.linear is not None else np.hstack([kernels, state])
        target = standard if self.linear is None else standard - self.linear * state
        system = NormalEquations.of(features, target)
        every = np.arange(features.shape[1])
        kernel, others = np.split(every, [len(chosen)])
        kept = self._choose(system.restrict(kernel))
        some = system.restrict(np.concatenate([kept, others]))
        self.coef_, self.intercept_ = some.unscaled(some.solve(self.damping), slice(None))
        self.centres_x_, self.centres_z_ = self.centres_x_[kept], self.centres_z_[kept]
        del self._scaled_centres
        self.kept_ = len(kept) / len(chosen)
        return self

    def _choose(self, system: NormalEquations) -> Indices:
        """Return which kernels are kept."""
        size = len(system.gram)
        if self.keep_at_most is None:
            return np.arange(size)
        count = max(1, int(self.keep_at_most * size))
        first = FirstBridges(system)
        return np.sort(sparsest_within(first, count, _FIRST_NU, 200, 1e-2)[1].kept)

    def predict(self, predicted: ArrayLike, z: ArrayLike) -> Array:
        """Estimate poses (n, D) from predictions (n, D) and descriptors (n, d)."""
        return self.explain(predicted, z)[0]

    def explain(self, predicted: ArrayLike, z: ArrayLike) -> tuple[Array, Array]:
        """Estimate as `predict` does; return the kernels K_x K_z of Eq. 10, shape (n, k), too."""
        check_is_fitted(self)
        state = self._standard(predicted)
        scaled = self._scaled(state, np.sqrt(np.asarray(z, dtype=float)))
        kernels = _kernels(scaled, self._scaled_centres)
        if self.linear is None:
            estimated = np.hstack([kernels, state]) @ self.coef_ + self.intercept_
        else:
            estimated = self.linear * state + kernels @ self.coef_ + self.intercept_
        return estimated * self.scale_ + self.mean_, kernels

    def to_arrays(self) -> State:
        """Return parameters and fitted attributes as arrays and numbers."""
        check_is_fitted(self)
        return arrays_of(self, _FITTED)

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore a regressor from the result of `to_arrays`."""
        return estimator_from(cls, state, _FITTED)

    def _standard(self, x: ArrayLike) -> Array:
        return (np.asarray(x, dtype=float) - self.mean_) / self.scale_

    @cached_property
    def _scaled_centres(self) -> tuple[Array, Array]:
        """Centres and their squared lengths, which take longer than the kernels of a frame."""
        scaled = self._scaled(self.centres_x_, self.centres_z_)
        return scaled, (scaled**2).sum(axis=1)

    def _scaled(self, state: Array, roots: Array) -> Array:
        """Put poses and roots of descriptors side by side, so that distances are exponents."""
        return np.hstack([np.sqrt(self.beta_x_) * state, np.sqrt(self.beta_z_) * roots])


def _kernels(scaled: Array, centres: tuple[Array, Array]) -> Array:
    exponent = squared_distances(scaled, *centres)
    return np.exp(np.negative(exponent, out=exponent), out=exponent)


def observed_and_sampled(
    takes: Examples,
    dynamics: SecondOrderDynamics,
    samples: int = 3,
    local: float = 1.0,
    along: float = 2.0,
    seed: int | None = 0,
    most: int = 20_000,
) -> tuple[Array, Array, Array]:
    """Make the training examples of section V-B.

    Observed predictions alone are so good that a regressor would over-trust them. So states are
    also sampled around the true ones, under the same silhouette.

    Parameters
    ----------
    takes : sequence of (z, x)
        Descriptors (F, d) and poses (F, D) of each take.
    dynamics : SecondOrderDynamics
        Fitted.
    samples : int, default=3
        Number of artificial examples for each observed one.
    local : float, default=1.0
        Standard deviation of the samples, relative to the scatter of the nearest training poses.
    along : float, default=2.0
        Further standard deviation along the trajectory, in frames.
    seed : int or None, default=0
        Seed of the samples.
    most : int, default=20_000
        Number of examples, about; of more, an even share is returned.

    Returns
    -------
    predicted : ndarray, shape (n, D)
        Predictions x̌.
    z : ndarray, shape (n, d)
    x : ndarray, shape (n, D)
        True poses.
    """
    random = np.random.default_rng(seed)
    every = np.concatenate([x for _, x in takes])
    scale = dynamics.scale_
    count = min(_NEIGHBOURS + 1, len(every))
    near = NearestNeighbors(n_neighbors=count).fit(every / scale)
    examples = []
    for z, x in takes:
        examples.append((dynamics.predict(x[1:-1], x[:-2]), z[2:], x[2:]))
        around = every[near.kneighbors(x / scale, return_distance=False)[:, 1:]] - x[:, None]
        velocity = np.gradient(x, axis=0) if len(x) > 1 else np.zeros_like(x)
        for _ in range(samples):
            # A random combination of the differences has their scatter as covariance.
            mixed = random.standard_normal((len(x), around.shape[1])) / np.sqrt(around.shape[1])
            offset = local * np.einsum("fn,fnd->fd", mixed, around)
            offset += along * random.standard_normal((len(x), 1)) * velocity
            examples.append((x + offset, z, x))
    every_few = ceil(sum(len(part) for part, _, _ in examples) / most)
    predicted, z, x = (np.concatenate(p)[::every_few] for p in zip(*examples, strict=True))
    return predicted, z, x
