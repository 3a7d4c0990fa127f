"""Mixtures of regressors: the density p(x|z) of poses for a descriptor, and its distinct modes.

Fitted to descriptors and poses of training takes; predicts from single descriptors.
"""

from silpose.regression.mixture.mixture import MixtureOfRegressors
from silpose.regression.mixture.modes import MODES, distinct_modes, normalised
from silpose.regression.mixture.reduction import PoseDirections, whitening

__all__ = [
    "MODES",
    "MixtureOfRegressors",
    "PoseDirections",
    "distinct_modes",
    "normalised",
    "whitening",
]
