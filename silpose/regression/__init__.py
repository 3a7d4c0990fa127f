"""From descriptors z to poses x: ridge, relevance vector and support vector regression.

>>> import numpy as np
>>> z = np.random.default_rng(0).random((60, 5))
>>> x = np.stack([z[:, 0] * z[:, 1], np.sin(z[:, 2])], axis=1)
>>> rvm = RelevanceVectorRegressor(nu=0.5).fit(z, x)
>>> estimated, std = rvm.predict(z, return_std=True)
>>> print(estimated.shape, std.shape, f"{rvm.kept_:.0%} of the examples kept")
(60, 2) (60, 2) 15% of the examples kept
"""

from silpose.regression.basis import Basis
from silpose.regression.mixture.mixture import MixtureOfRegressors
from silpose.regression.mixture.modes import normalised
from silpose.regression.regressor import Regressor
from silpose.regression.ridge import RidgeRegressor
from silpose.regression.selection.mixtures import MixtureSettings, choose_mixture
from silpose.regression.selection.regressors import Candidates, Chosen
from silpose.regression.selection.settings import (
    BasisSettings,
    RidgeSettings,
    RvmSettings,
    SvmSettings,
    check_methods,
)
from silpose.regression.sparse.bridge_path import BridgePath, follow_bridges
from silpose.regression.sparse.rvm import RelevanceVectorRegressor
from silpose.regression.svm import SupportVectorRegressor

REGRESSORS: dict[str, type[Regressor]] = {
    kind.__name__: kind
    for kind in (RidgeRegressor, RelevanceVectorRegressor, SupportVectorRegressor)
}

__all__ = [
    "REGRESSORS",
    "Basis",
    "BasisSettings",
    "BridgePath",
    "Candidates",
    "Chosen",
    "MixtureOfRegressors",
    "MixtureSettings",
    "Regressor",
    "RelevanceVectorRegressor",
    "RidgeRegressor",
    "RidgeSettings",
    "RvmSettings",
    "SupportVectorRegressor",
    "SvmSettings",
    "check_methods",
    "choose_mixture",
    "follow_bridges",
    "normalised",
]
