"""Confidence in poses: the calibrated probability that a pose is right."""

from silpose.model.confidence.confidence import Confidence
from silpose.model.confidence.source import doubted_as_a_source
from silpose.model.confidence.training import train_confidence

__all__ = ["Confidence", "doubted_as_a_source", "train_confidence"]
