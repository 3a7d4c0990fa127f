"""A mixture of regressors as arrays and numbers, and back."""

from __future__ import annotations

from dataclasses import fields

import numpy as np
from sklearn.utils.validation import check_is_fitted

from silpose.core.serialisation import State, arrays_of, estimator_from, prefixed, without_prefix
from silpose.regression.mixture.experts import Experts
from silpose.regression.mixture.mixture import MixtureOfRegressors
from silpose.regression.mixture.reduction import PoseDirections
from silpose.regression.mixture.shared_regressor import SharedRegressor
from silpose.regression.regressor import Regressor

_MIXTURE = ("mean_", "scale_", "varies_", "anywhere_", "n_features_in_", "_single")
_REDUCTION = ("mean_", "components_")


def mixture_state(mixture: MixtureOfRegressors) -> State:
    """Give what is needed to answer."""
    check_is_fitted(mixture)
    experts = {field.name: getattr(mixture.experts_, field.name) for field in fields(Experts)}
    reduction = arrays_of(mixture.reduction_, _REDUCTION)
    own = (
        arrays_of(mixture, _MIXTURE)
        | prefixed("experts", experts)
        | prefixed("reduction", reduction)
    )
    shared = mixture.shared_
    if shared is None:
        return own
    return own | prefixed("shared", shared.regressor.to_arrays() | {"variances": shared.variances})


def mixture_from(state: State) -> MixtureOfRegressors:
    """Restore what `mixture_state` gave."""
    mixture = estimator_from(MixtureOfRegressors, state, _MIXTURE)
    experts = {name: np.asarray(value) for name, value in without_prefix("experts", state).items()}
    mixture.experts_ = Experts(**experts)
    mixture.reduction_ = estimator_from(
        PoseDirections, without_prefix("reduction", state), _REDUCTION
    )
    shared = without_prefix("shared", state)
    mixture.shared_ = None
    if shared:
        regressor = Regressor.from_arrays(shared)
        mixture.shared_ = SharedRegressor(regressor, np.asarray(shared["variances"]))
    return mixture
