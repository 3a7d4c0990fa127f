"""Every parameter of every public estimator: refused by its name, or the answer is finite."""

import inspect
import warnings

import numpy as np
import pytest
from sklearn.base import BaseEstimator, clone

from silpose import descriptor, regression, tracking
from silpose.core.errors import InputError
from silpose.descriptor import AlignedMask, HuMoments, ShapeContextHistogram
from silpose.regression import Basis, MixtureOfRegressors, Regressor
from silpose.tracking import MultipleHypothesisTracker, StateSensitiveRegressor, Tracker

VALUES = [
    np.nan,
    np.inf,
    -np.inf,
    None,
    "a",
    "",
    -1,
    0,
    0.5,
    2,
    9.5,
    1e30,
    True,
    [],
    {},
    np.ones(3),
]
FRAMES = 14
ABSTRACT = (Regressor, Tracker)


def public_estimators():
    modules = (regression, tracking, descriptor)
    found = [getattr(module, name) for module in modules for name in module.__all__]
    kinds = [kind for kind in found if inspect.isclass(kind) and issubclass(kind, BaseEstimator)]
    return [kind for kind in kinds if kind not in ABSTRACT]


def small(kind):
    """An estimator that a few examples are enough for."""
    if kind is MixtureOfRegressors:
        return kind(2, max_iter=2)
    if kind is MultipleHypothesisTracker:
        return kind(MixtureOfRegressors(2, max_iter=2), n_particles=5)
    if kind is ShapeContextHistogram:
        return kind(codebook_size=5, edge_points=20)
    return kind(size=8, components=2) if kind is AlignedMask else kind()


def answer(estimator, z, x, masks):
    """Fit to a few examples, and give what is made of them."""
    if isinstance(estimator, ShapeContextHistogram | AlignedMask | HuMoments):
        return estimator.fit(masks).transform(masks)
    if isinstance(estimator, Tracker):
        return estimator.fit([(z, x)]).track(z, x[:2]).x
    if isinstance(estimator, StateSensitiveRegressor):
        return estimator.fit(x, z, x).predict(x, z)
    if isinstance(estimator, Basis):
        return estimator.fit(z).transform(z)
    if isinstance(estimator, tracking.SecondOrderDynamics):
        return estimator.fit([x]).predict(x[1], x[0])
    return estimator.fit(z, x).predict(z)


@pytest.fixture(scope="module")
def examples():
    t = np.arange(FRAMES)[:, None]
    x = 20 * np.cos(0.5 * t + np.arange(55))
    x[:, :2] = 1.0, 0.0
    z = 1 + np.sin(0.5 * t + np.arange(6))
    masks = [np.zeros((24, 20), np.uint8) for _ in range(FRAMES)]
    for k, mask in enumerate(masks):
        mask[3:20, 4 : 9 + k % 7] = 1
    return z, x, masks


@pytest.mark.slow
@pytest.mark.parametrize("kind", public_estimators(), ids=lambda kind: kind.__name__)
def test_any_value_of_any_parameter_is_refused_by_name_or_gives_a_finite_answer(kind, examples):
    silent = []
    for name in small(kind).get_params(deep=False):
        for value in VALUES:
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    found = answer(clone(small(kind)).set_params(**{name: value}), *examples)
                if not np.isfinite(found).all():
                    silent.append(f"{name}={value!r}: not finite")
            except InputError as error:
                # Parts that None stands for name their own parameters.
                if (name not in str(error) and value is not None) or "\n" in str(error):
                    silent.append(f"{name}={value!r}: {error}")
            except Exception as error:
                silent.append(f"{name}={value!r}: {type(error).__name__} {error}")
    assert not silent
