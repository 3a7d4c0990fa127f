"""Regression from descriptors z to poses x: ridge, RVM, SVM, mixtures, and the choice of settings.

Takes descriptors and poses of training takes as arrays; the fitted estimators go to models,
trackers and evaluation.

>>> import numpy as np
>>> z = np.random.default_rng(0).random((60, 5))
>>> x = np.stack([z[:, 0] * z[:, 1], np.sin(z[:, 2])], axis=1)
>>> rvm = RelevanceVectorRegressor(Basis(width=1.0, hellinger=False), nu=0.5).fit(z, x)
>>> estimated, std = rvm.predict(z, return_std=True)
>>> print(estimated.shape, std.shape, f"{rvm.kept_:.0%} of the examples kept")
(60, 2) (60, 2) 15% of the examples kept
"""

from silpose.regression.basis import Basis
from silpose.regression.blocks import FileBlock, file_blocks, split_rows, stored_blocks
from silpose.regression.distinct_neighbours import DistinctNeighbours
from silpose.regression.mixture import MODES, MixtureOfRegressors, normalised
from silpose.regression.regressor import Regressor
from silpose.regression.ridge import RidgeRegressor
from silpose.regression.selection import (
    Candidates,
    ChosenMixture,
    ChosenRegressors,
    Fold,
    Outcome,
    RegressionCandidates,
    best,
    check_methods,
    choose_mixture,
    choose_regressors,
    folds,
    search,
)
from silpose.regression.sparse import BridgePath, RelevanceVectorRegressor, follow_bridges
from silpose.regression.svm import SupportVectorRegressor

REGRESSORS: dict[str, type[Regressor]] = {
    kind.__name__: kind
    for kind in (RidgeRegressor, RelevanceVectorRegressor, SupportVectorRegressor)
}

__all__ = [
    "MODES",
    "REGRESSORS",
    "Basis",
    "BridgePath",
    "Candidates",
    "ChosenMixture",
    "ChosenRegressors",
    "DistinctNeighbours",
    "FileBlock",
    "Fold",
    "MixtureOfRegressors",
    "Outcome",
    "RegressionCandidates",
    "Regressor",
    "RelevanceVectorRegressor",
    "RidgeRegressor",
    "SupportVectorRegressor",
    "best",
    "check_methods",
    "choose_mixture",
    "choose_regressors",
    "file_blocks",
    "folds",
    "follow_bridges",
    "normalised",
    "search",
    "split_rows",
    "stored_blocks",
]
