"""From descriptors z to poses x: ridge and relevance vector regression on kernel bases.

>>> import numpy as np
>>> z = np.random.default_rng(0).random((60, 5))
>>> x = np.stack([z[:, 0] * z[:, 1], np.sin(z[:, 2])], axis=1)
>>> rvm = RelevanceVectorRegressor(nu=0.5).fit(z, x)
>>> rvm.predict(z[:1]).shape, rvm.kept_ < 1
((1, 2), True)
"""

from silpose.regression.basis import GaussianBasis
from silpose.regression.regressor import Regressor
from silpose.regression.ridge import RidgeRegressor
from silpose.regression.rvm import RelevanceVectorRegressor
from silpose.regression.selection import (
    BasisSettings,
    Candidates,
    Chosen,
    RidgeSettings,
    RvmSettings,
    check_methods,
)

REGRESSORS: dict[str, type[Regressor]] = {
    kind.__name__: kind for kind in (RidgeRegressor, RelevanceVectorRegressor)
}

__all__ = [
    "REGRESSORS",
    "BasisSettings",
    "Candidates",
    "Chosen",
    "GaussianBasis",
    "Regressor",
    "RelevanceVectorRegressor",
    "RidgeRegressor",
    "RidgeSettings",
    "RvmSettings",
    "check_methods",
]
