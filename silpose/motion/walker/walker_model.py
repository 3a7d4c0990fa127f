"""A statistical model of walkers, from which plausible gaits are drawn.

It is a Gaussian over the coefficients of real walks (mean posture, two harmonics of the stride,
cadence) in the space of their principal components. `silpose.motion.walker.fit_walker` fits it.

The file ``walker.npz`` was fitted to walks of eight people of the CMU database and of one of
Seoul National University's Movement Research Laboratory (snumrl/ys2010, Apache-2.0). The CMU data
was obtained from mocap.cs.cmu.edu; the database was created with funding from NSF EIA-0196217.

References
----------
N. F. Troje, "Decomposing biological motion", Journal of Vision 2002.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from silpose.core import skeleton
from silpose.core.types import Array
from silpose.motion.walker.walker import Variation, Walker

FILE = Path(__file__).with_name("walker.npz")
"""The model that comes with silpose."""

_DRAWS = 100  # at most, until a walker is plausible


class WalkerModel:
    """Gaussian over the coefficients of real walks.

    Parameters
    ----------
    mean : ndarray, shape (C,)
        Mean coefficients, see `pack`.
    components : ndarray, shape (K, C)
        Principal components, each of the length of its standard deviation.
    variation : Variation
        Variation between the strides of every walker.
    """

    def __init__(self, mean: Array, components: Array, variation: Variation) -> None:
        self.mean = mean
        self.components = components
        self.variation = variation

    @classmethod
    def load(cls, file: str | Path = FILE) -> WalkerModel:
        """Read a model, by default the one that comes with silpose."""
        with np.load(file, allow_pickle=False) as stored:
            variation = Variation(
                float(stored["stride_time"]),
                float(stored["amplitude"]),
                stored["posture"].astype(float),
            )
            return cls(stored["mean"].astype(float), stored["components"].astype(float), variation)

    def save(self, file: str | Path = FILE) -> None:
        """Write the model, in single precision."""
        np.savez_compressed(
            file,
            mean=self.mean.astype(np.float32),
            components=self.components.astype(np.float32),
            stride_time=self.variation.stride_time,
            amplitude=self.variation.amplitude,
            posture=self.variation.posture.astype(np.float32),
        )

    def sample(self, rng: np.random.Generator, spread: float = 1.0) -> Walker:
        """Draw a walker, each component within two standard deviations.

        People hardly swing their arms, so that the Gaussian has some swing them in step with the
        legs; those are drawn again.

        Parameters
        ----------
        rng : numpy.random.Generator
        spread : float, default=1.0
            Variation between walkers, as a share of the variation between people; 0 gives the
            mean walker.

        Returns
        -------
        walker : Walker
        """
        for _ in range(_DRAWS):
            scores = np.clip(rng.standard_normal(len(self.components)), -2.0, 2.0)
            walker = unpack(self.mean + spread * scores @ self.components, self.variation)
            if _arms_against_legs(walker):
                break
        return walker


def pack(mean: Array, harmonics: Array, cadence: float) -> Array:
    """Coefficients of a gait in one vector, shape (271,), the cadence in strides per minute.

    In that unit the cadence varies between people about as much as an angle in degrees does.
    """
    return np.concatenate([mean, harmonics.ravel(), [60.0 * cadence]])


def unpack(coefficients: Array, variation: Variation) -> Walker:
    """Make a walker from its coefficients; the inverse of `pack`."""
    angles = len(skeleton.ANGLES)
    return Walker(
        coefficients[:angles].copy(),
        coefficients[angles:-1].reshape(2, 2, angles).copy(),
        float(coefficients[-1] / 60.0),
        variation,
    )


def _arms_against_legs(walker: Walker) -> bool:
    """Whether the left wrist is in front of the right one while the left ankle is behind."""
    phase = np.linspace(0.0, 2 * np.pi, 40, endpoint=False)
    rotations = skeleton.rotations_from_angles(walker.angles(phase))
    points = skeleton.forward_kinematics(rotations)[0]
    arms, legs = (
        points[:, skeleton.POINTS.index(f"left_{end}"), 2]
        - points[:, skeleton.POINTS.index(f"right_{end}"), 2]
        for end in ("wrist", "ankle")
    )
    return bool(np.sum((arms - arms.mean()) * (legs - legs.mean())) < 0)
