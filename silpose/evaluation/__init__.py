"""Metrics and baselines."""

from silpose.evaluation.baselines import BASELINES, baselines
from silpose.evaluation.metrics import heading_errors, joint_distances, measure

__all__ = ["BASELINES", "baselines", "heading_errors", "joint_distances", "measure"]
