"""Confidence: the probability that a fitted pose is right, by the evidence for it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import minimize
from scipy.special import expit

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.fitting.evidence import EVIDENCE

DOUBTFUL = 0.5
"""Confidence below which a pose is doubtful, and a fit poor."""

_WEIGHTS = (1.98, -0.41, -1.46, -1.31, -0.28, 1.41, -0.31, -0.21, 0.0, -0.56)
_STRENGTH = 0.5  # of what holds learned weights near those that are expected


@dataclass(frozen=True)
class Confidence:
    """Logistic regression from evidence to the probability that a pose is right.

    Attributes
    ----------
    weights : tuple of float
        A constant, and one for each of `EVIDENCE`; by default those of walkers and captured
        people who were left out of training, of damaged masks and of shapes that are no person's.
    usual_iou : float, default=0.95
        Overlap of body and mask in training, in relation to which an overlap is judged.
    """

    weights: tuple[float, ...] = _WEIGHTS
    usual_iou: float = 0.95

    def __post_init__(self) -> None:
        if len(self.weights) != 1 + len(EVIDENCE):
            raise InputError(
                f"a confidence has {1 + len(EVIDENCE)} weights, not {len(self.weights)}: retrain it"
            )

    def of(self, evidence: Array) -> Array:
        """Find the confidences (F,) of frames with evidence (F, 9); 0 where it is NaN."""
        known = np.isfinite(evidence).all(axis=1)
        confidence = np.zeros(len(evidence))
        confidence[known] = expit(self._inputs(evidence[known]) @ np.array(self.weights))
        return confidence

    def learned_from(self, evidence: Array, right: Array) -> Confidence:
        """Learn weights from frames with evidence (F, 9), of which some are right (F,).

        They are held near the present ones where there is little to learn from.
        """
        inputs, expected = self._inputs(evidence), np.array(self.weights)
        sign = np.where(right, 1.0, -1.0)

        def cost(weights: Array) -> tuple[float, Array]:
            margin = sign * (inputs @ weights)
            off = weights - expected
            value = np.logaddexp(0, -margin).sum() + _STRENGTH * off @ off
            return float(value), -(sign * expit(-margin)) @ inputs + 2 * _STRENGTH * off

        found = minimize(cost, expected, jac=True, method="L-BFGS-B")
        return Confidence(tuple(float(w) for w in found.x), self.usual_iou)

    def _inputs(self, evidence: Array) -> Array:
        inputs = np.concatenate([np.ones((len(evidence), 1)), evidence], axis=1)
        inputs[:, 1] -= np.log(max(1 - self.usual_iou, 0.01))
        return inputs
