"""Confidence in poses: the calibrated probability that a pose is right."""

from silpose.model.confidence.confidence import Confidence
from silpose.model.confidence.training import train_confidence

__all__ = ["Confidence", "train_confidence"]
