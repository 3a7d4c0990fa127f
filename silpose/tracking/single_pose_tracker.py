"""The paper's own tracker: one pose, predicted by dynamics, corrected by regression (section V)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.state_sensitive import StateSensitiveRegressor, observed_and_sampled

Array = NDArray[np.float64]
Examples = Sequence[tuple[Array, Array]]


@dataclass
class SinglePoseTracker:
    """Carries a single pose.

    Attributes
    ----------
    dynamics : SecondOrderDynamics
    regressor : StateSensitiveRegressor
    samples : int
        Artificial training examples for each observed one.
    """

    dynamics: SecondOrderDynamics
    regressor: StateSensitiveRegressor
    samples: int = 3

    def fit(self, sequences: Examples) -> SinglePoseTracker:
        """Learn dynamics and correction from training sequences ``(z, x)``."""
        self.dynamics.fit([x for _, x in sequences])
        self.regressor.fit(*observed_and_sampled(sequences, self.dynamics, self.samples))
        return self

    def track(self, z: ArrayLike, initial: ArrayLike) -> tuple[Array, Array]:
        """Track a sequence from its first two poses.

        Parameters
        ----------
        z : array-like, shape (F, d)
        initial : array-like, shape (2, D)

        Returns
        -------
        x : ndarray, shape (F, D)
        activations : ndarray, shape (F, k)
            Of the kernels (Eq. 10); zero in the first two frames.
        """
        z = np.asarray(z, dtype=float)
        x = [np.asarray(pose, dtype=float) for pose in np.asarray(initial)[:2]]
        activations = np.zeros((len(z), len(self.regressor.centres_x_)))
        mean, reach = self.dynamics.mean_, _REACH * self.dynamics.scale_
        for frame in range(2, len(z)):
            predicted = self.dynamics.predict(x[-1], x[-2])[None]
            predicted = np.clip(predicted, mean - reach, mean + reach)  # a lost one may run away
            estimated, kernels = self.regressor.explain(predicted, z[frame : frame + 1])
            activations[frame] = kernels[0]
            x.append(estimated[0])
        return np.array(x[: len(z)]), activations


_REACH = 10.0  # standard deviations from the mean pose within which a state is kept
