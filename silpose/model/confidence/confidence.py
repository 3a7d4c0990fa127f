"""`Confidence`: the calibrated probability that an estimated pose is right."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Self

import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import SPACES, PoseSpace, wrap_degrees
from silpose.core.serialisation import State, prefixed, without_prefix
from silpose.core.types import Array
from silpose.model.confidence.evidence import TrainingExamples
from silpose.model.confidence.monotone_logistic import MonotoneLogistic, probability_of
from silpose.silhouette.person import MaskFacts

HEADING_DEG, JOINTS_MM = 45.0, 120.0
"""Errors up to which a pose is right."""

UNSEEN = 0.25
"""Confidence in a pose of a frame in which nobody was seen, as a tracker gives."""

_LEAST_MISS = 0.01  # share that an overlap misses at the least
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
    fit_calibration : MonotoneLogistic or None, default=None
        For fitted poses, from what `fit_evidence` returns to the probability; None for a model
        without a fitter.

    See Also
    --------
    silpose.model.confidence.train_confidence : Trains one.
    """

    examples: TrainingExamples
    calibration: MonotoneLogistic
    fit_calibration: MonotoneLogistic | None = None

    def of(
        self, z: Array, x: Array, facts: MaskFacts | None = None, iou: Array | None = None
    ) -> Array:
        """Judge poses.

        Parameters
        ----------
        z : ndarray, shape (F, d)
            Descriptors; NaN where nobody was seen.
        x : ndarray, shape (F, D)
            Estimated, tracked or fitted poses; NaN where there is none.
        facts : MaskFacts, optional
            Of the masks; not given if there are descriptors only.
        iou : ndarray, shape (F,), optional
            Overlap of the fitted body and the mask, for fitted poses.

        Returns
        -------
        confidence : ndarray, shape (F,)
            From 0 to 1; 0 where there is no pose, and 0.25 where there is a pose but nobody was
            seen, as in the gaps of a track.
        """
        posed, seen = np.isfinite(x).all(axis=1), np.isfinite(z).all(axis=1)
        confidence = np.where(posed, UNSEEN, 0.0)
        judged = np.flatnonzero(posed & seen)
        if len(judged) == 0:
            return confidence
        own = None if facts is None else facts[judged]
        odds = self.odds(z[judged], x[judged], own)
        if iou is not None and self.fit_calibration is not None:
            odds = self.fit_calibration.odds(fit_evidence(odds, iou[judged]))
        confidence[judged] = probability_of(odds)
        return confidence

    def odds(self, z: Array, x: Array, facts: MaskFacts | None) -> Array:
        """Logarithm of the odds that poses are right, shape (F,), without the evidence of a fit."""
        return self.calibration.odds(self.examples.evidence(z, x, facts))

    def to_arrays(self) -> State:
        """Return everything as arrays, numbers and strings."""
        state: State = {"space": self.examples.space.name}
        state |= prefixed("examples", {name: getattr(self.examples, name) for name in _ARRAYS})
        state |= prefixed("calibration", self.calibration.to_arrays())
        if self.fit_calibration is not None:
            state |= prefixed("fit_calibration", self.fit_calibration.to_arrays())
        return state

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore from the result of `to_arrays`."""
        arrays, calibration, of_fits = (
            without_prefix(part, state) for part in ("examples", "calibration", "fit_calibration")
        )
        parts = {name: np.asarray(arrays[name]) for name in _ARRAYS}
        examples = TrainingExamples(**parts, space=SPACES[str(state["space"])])
        return cls(
            examples,
            MonotoneLogistic.from_arrays(calibration),
            MonotoneLogistic.from_arrays(of_fits) if of_fits else None,
        )


def fit_evidence(odds: Array, iou: Array) -> Array:
    """Evidence about fitted poses, larger for stranger ones.

    Parameters
    ----------
    odds : ndarray, shape (F,)
        Logarithm of the odds without the fit.
    iou : ndarray, shape (F,)
        Overlap of the fitted body and the mask.

    Returns
    -------
    evidence : ndarray, shape (F, 2)
        Minus these odds, and the logarithm of the share that the overlap misses.
    """
    miss = np.log(np.maximum(1 - np.nan_to_num(iou), _LEAST_MISS))
    return np.stack([-np.asarray(odds), miss], axis=1)


def right_poses(space: PoseSpace, true: Array, estimated: Array) -> NDArray[np.bool_]:
    """Whether poses are right, shape (F,): heading within 45 degrees, joints within 120 mm.

    Parameters
    ----------
    space : PoseSpace
    true, estimated : ndarray, shape (F, D)
    """
    turned = np.abs(wrap_degrees(space.heading(true) - space.heading(estimated)))
    apart = np.linalg.norm(space.joints(true) - space.joints(estimated), axis=-1)[:, 1:18]
    return np.asarray((turned <= HEADING_DEG) & (1000 * apart.mean(axis=1) <= JOINTS_MM))
