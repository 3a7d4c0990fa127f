"""`Confidence`: the calibrated probability that an estimated pose is right."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Self

import numpy as np

from silpose.core.pose_space import SPACES
from silpose.core.serialisation import State, prefixed, without_prefix
from silpose.core.types import Array
from silpose.model.confidence.evidence import TrainingExamples
from silpose.model.confidence.monotone_logistic import MonotoneLogistic, probability_of
from silpose.silhouette.person import MaskFacts

UNSEEN = 0.25
"""Confidence in a pose of a frame in which nobody was seen, as a tracker gives."""

UPSIDE_DOWN = 0.25
"""Highest confidence in a pose of a mask that looks like a person upside down."""

_ARRAYS = tuple(f.name for f in fields(TrainingExamples) if f.name != "space")


@dataclass(frozen=True, eq=False)
class Confidence:
    """How probable it is that a pose is right, from what silhouette and pose have in common.

    A pose is right if the heading is within 45 degrees and the joints are within 120 mm, on
    average.

    Attributes
    ----------
    examples : TrainingExamples
        Examples that silhouettes and poses are compared with.
    calibration : MonotoneLogistic
        From evidence to the probability.

    See Also
    --------
    silpose.model.confidence.train_confidence : Trains one.
    """

    examples: TrainingExamples
    calibration: MonotoneLogistic

    def of(self, z: Array, x: Array, facts: MaskFacts | None = None) -> Array:
        """Judge poses.

        Parameters
        ----------
        z : ndarray, shape (F, d)
            Descriptors; NaN where nobody was seen.
        x : ndarray, shape (F, D)
            Estimated or tracked poses; NaN where there is none.
        facts : MaskFacts, optional
            Of the masks; not given if there are descriptors only.

        Returns
        -------
        confidence : ndarray, shape (F,)
            From 0 to 1; 0 where there is no pose, 0.25 where there is a pose but nobody was seen,
            as in the gaps of a track, and at most 0.25 where somebody seems to be upside down.
        """
        posed, seen = np.isfinite(x).all(axis=1), np.isfinite(z).all(axis=1)
        confidence = np.where(posed, UNSEEN, 0.0)
        judged = np.flatnonzero(posed & seen)
        if len(judged) == 0:
            return confidence
        own = None if facts is None else facts[judged]
        evidence = self.examples.evidence(z[judged], x[judged], own)
        confidence[judged] = probability_of(self.calibration.odds(evidence))
        if own is not None:
            confidence[judged] = np.minimum(confidence[judged], self.highest(own))
        return confidence

    def highest(self, facts: MaskFacts) -> Array:
        """Highest confidence (F,) in any pose of these masks, a fitted one, too."""
        return np.where(self.examples.upside_down(facts), UPSIDE_DOWN, 1.0)

    def to_arrays(self) -> State:
        """Return everything as arrays, numbers and strings."""
        state: State = {"space": self.examples.space.name}
        state |= prefixed("examples", self.examples.to_arrays())
        state |= prefixed("calibration", self.calibration.to_arrays())
        return state

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore from the result of `to_arrays`."""
        arrays, calibration = (without_prefix(p, state) for p in ("examples", "calibration"))
        parts = {name: np.asarray(arrays[name]) for name in _ARRAYS}
        examples = TrainingExamples(**parts, space=SPACES[str(state["space"])])
        return cls(examples, MonotoneLogistic.from_arrays(calibration))
