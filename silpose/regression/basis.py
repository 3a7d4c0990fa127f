"""Basis functions f(z) of the regression: kernels at training examples, or the features themselves.

Section III-C of the paper.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import ClassVar, Literal

import numpy as np
from numpy.typing import ArrayLike
from sklearn.utils import Tags
from sklearn.utils.validation import validate_data

from silpose.core.errors import InputError
from silpose.core.parameters import (
    FLAG,
    POSITIVE,
    POSITIVE_INTEGER,
    SEED,
    Constraints,
    check_parameters,
    one_of,
)
from silpose.core.random_states import RandomState, generator_of
from silpose.core.types import Array, Indices
from silpose.regression.centres import CHOICES, choose_rows
from silpose.regression.fitted_basis import FittedBasis
from silpose.regression.kernels import (
    KERNELS,
    OTHER_KERNELS,
    sampled_rows,
    typical_distance,
)


class Basis(FittedBasis):
    """Kernels K(z, z_k) at training points z_k, the features of z, or both together.

    Parameters
    ----------
    kernel : str or None, default="gaussian"
        ``"gaussian"``, exp(-β ‖z - z_k‖²), any other kernel of
        `sklearn.metrics.pairwise.pairwise_kernels` by its name there, or None for no kernels.
    linear : bool, default=False
        Whether the features themselves, at zero mean and unit variance, are basis functions too.
    centres : int, default=2700
        Largest number of training points that carry a kernel; of more, a random subset does.
    width : float or "auto", default="auto"
        Factor of β, in units of 1 / (2 tr S), S the scatter (covariance) matrix of the
        training inputs: the larger, the narrower the kernels. 2 tr S is the mean squared distance
        of two inputs; other kernels take the mean of their own distance. "auto" is chosen by a
        regressor's `fit`, by leave-one-out; it is 1 where there are no outputs to choose by.
    hellinger : bool, default=True
        Whether to take square roots of the inputs first, so that their Euclidean distance is
        the Hellinger distance of histograms; inputs must not be negative then.
    normalised : bool, default=False
        Whether Gaussian kernels are divided by their sum over all centres [1]_. Far from all
        training points, as a damaged silhouette is, the nearest ones then still respond, where
        plain kernels vanish and leave the mean. The sum needs all centres, even where only some
        kernels are kept.
    choice : {"random", "kmeans", "farthest"}, default="random"
        How the training points that carry a kernel are chosen, where there are more: at random,
        as those nearest to the means of a mini-batch k-means, or each far from all others.
    random_state : int, RandomState, Generator or None, default=0
        Seed of the choice.

    Attributes
    ----------
    indices_ : ndarray of int, shape (k,)
        Training rows that carry a kernel.
    centres_ : ndarray, shape (k, d)
    features_ : ndarray of int
        Features that are basis functions; they come after the kernels.
    beta_ : float
    size_ : int
        Number of basis functions.
    summed_ : ndarray, shape (p, d)
        Centres over which normalised kernels are summed.
    places_ : ndarray of int, shape (k,)
        Rows of `summed_` whose kernels are kept.

    References
    ----------
    .. [1] J. Moody and C. Darken, "Fast learning in networks of locally-tuned processing units",
       Neural Computation 1989.
    """

    constraints: ClassVar[Constraints] = {
        "kernel": one_of(*KERNELS, *OTHER_KERNELS).or_none(),
        "centres": POSITIVE_INTEGER,
        "width": POSITIVE.or_word("auto"),
        "linear": FLAG,
        "hellinger": FLAG,
        "normalised": FLAG,
        "choice": one_of(*CHOICES),
        "random_state": SEED,
    }

    def __init__(
        self,
        kernel: str | None = "gaussian",
        *,
        linear: bool = False,
        centres: int = 2700,
        width: float | Literal["auto"] = "auto",
        hellinger: bool = True,
        normalised: bool = False,
        choice: Literal["random", "kmeans", "farthest"] = "random",
        random_state: RandomState = 0,
    ) -> None:
        self.kernel = kernel
        self.linear = linear
        self.centres = centres
        self.width = width
        self.hellinger = hellinger
        self.normalised = normalised
        self.choice = choice
        self.random_state = random_state

    def fit(self, z: ArrayLike, y: object = None) -> Basis:
        """Choose the centres and the width.

        Parameters
        ----------
        z : array-like, shape (n, d)
            Descriptors.
        y : object, default=None
            Ignored.

        Raises
        ------
        InputError
            If a parameter or an input cannot be used.
        """
        self.check()
        inputs = self.roots(validate_data(self, z, dtype=float))
        rows = self.choose_rows(len(inputs), lambda: iter([inputs]))
        sample = inputs[sampled_rows(len(inputs))]
        mean, variance = inputs.mean(axis=0), inputs.var(axis=0)
        return self.use_fitted(rows, inputs[rows], mean, variance, sample)

    def choose_rows(self, count: int, inputs: Callable[[], Iterator[Array]]) -> Indices:
        """Choose which training rows carry a kernel.

        Parameters
        ----------
        count : int
            Number of training rows.
        inputs : callable
            Returns an iterator over them in blocks, as `roots` returns them; called anew for
            every pass that the choice needs.

        Returns
        -------
        rows : ndarray of int
            In order.
        """
        wanted = min(self.centres, count) if self.kernel else 0
        random = generator_of(self.random_state)
        return choose_rows(self.choice, wanted, count, inputs, random)

    def use_fitted(
        self, rows: Indices, centres: Array, mean: Array, variance: Array, sample: Array
    ) -> Basis:
        """Use centres that have been chosen already; inputs are as `roots` returns them.

        Parameters
        ----------
        rows : ndarray of int, shape (k,)
            Training rows that carry a kernel.
        centres : ndarray, shape (k, d)
            Inputs at these.
        mean, variance : ndarray, shape (d,)
            Of all inputs.
        sample : ndarray, shape (n, d)
            Inputs at `sampled_rows`.
        """
        self.n_features_in_ = len(mean)
        self.indices_, self.centres_ = rows, centres
        if self.normalised:
            self.summed_, self.places_ = self.centres_, np.arange(len(rows))
        self.features_ = np.arange(len(mean) if self.linear else 0)
        self.mean_, self.scale_ = mean, np.where(variance > 0, np.sqrt(variance), 1.0)
        typical = typical_distance(self.kernel, mean, variance, sample) if self.kernel else 0.0
        width = 1.0 if self.width == "auto" else self.width
        self.beta_ = width / typical if typical > 0 else 1.0
        return self

    def __sklearn_tags__(self) -> Tags:
        tags = super().__sklearn_tags__()
        tags.input_tags.positive_only = self.hellinger
        return tags

    def check(self) -> None:
        """Raise `InputError` if a parameter cannot be used."""
        check_parameters(self)
        if self.kernel is None and not self.linear:
            raise InputError("a basis without kernels needs linear=True")
        if self.normalised and self.kernel != "gaussian":
            raise InputError(f"normalised=True needs kernel='gaussian', not {self.kernel!r}")
