"""Metrics and baselines."""

from silpose.evaluation.baselines import BASELINES, baselines
from silpose.evaluation.heading import heading_confidence, key_angles
from silpose.evaluation.metrics import heading_errors, joint_distances, measure
from silpose.evaluation.thigh_swing import thigh_swing

__all__ = [
    "BASELINES",
    "baselines",
    "heading_confidence",
    "heading_errors",
    "joint_distances",
    "key_angles",
    "measure",
    "thigh_swing",
]
