"""Choosing settings by validation: candidates, folds over takes, and the one search over both.

Takes descriptors and poses of training and validation takes; returns fitted estimators, and the
scores of all settings as rows of ``results.csv``.
"""

from silpose.regression.selection.candidates import Candidates
from silpose.regression.selection.folds import Fold, folds, partition
from silpose.regression.selection.methods import METHODS, check_methods
from silpose.regression.selection.mixtures import ChosenMixture, choose_mixture
from silpose.regression.selection.regressors import (
    ChosenRegressors,
    RegressionCandidates,
    choose_regressors,
)
from silpose.regression.selection.search import Outcome, best, search, settings_of

__all__ = [
    "METHODS",
    "Candidates",
    "ChosenMixture",
    "ChosenRegressors",
    "Fold",
    "Outcome",
    "RegressionCandidates",
    "best",
    "check_methods",
    "choose_mixture",
    "choose_regressors",
    "folds",
    "partition",
    "search",
    "settings_of",
]
