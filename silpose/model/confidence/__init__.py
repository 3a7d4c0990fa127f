"""Confidence in poses: the calibrated probability that a pose is right."""

from silpose.model.confidence.confidence import HEADING_DEG, JOINTS_MM, Confidence, right_poses
from silpose.model.confidence.training import train_confidence

__all__ = ["HEADING_DEG", "JOINTS_MM", "Confidence", "right_poses", "train_confidence"]
