import numpy as np
import pytest
from scipy.stats import norm

from silpose.regression import MixtureOfRegressors, RidgeRegressor
from silpose.regression.mixture.shared_regressor import SharedFit, SharedRegressor


@pytest.fixture
def examples():
    random = np.random.default_rng(0)
    z = random.random((300, 4))
    x = np.column_stack([z.sum(axis=1), random.choice([-1.0, 1.0], 300)])
    return z, x + 0.01 * random.standard_normal(x.shape)


def test_means_move_towards_it_where_its_error_is_small(examples):
    z, x = examples
    shares = np.column_stack([x[:, 0] < 2, x[:, 0] >= 2]).astype(float)
    x = np.column_stack([x, np.where(x[:, 0] < 2, 0.0, x[:, 1])])  # hard to predict beyond 2 only
    shared = SharedRegressor.within(SharedFit.of(RidgeRegressor(), z, x), shares)
    noises = np.full((2, 3), 0.05)

    def move(noises, width, which):  # how far a mean of 0 moves towards an estimate of 1
        means = np.zeros((1, len(which), 3))
        return shared.product(np.ones((1, 3)), means, noises, width, which)[1][0]

    moved = move(noises, 1.0, np.arange(2))
    assert (moved[:, 0] > 0.9).all() and (moved[:, 1] < 0.1).all()
    assert moved[0, 2] > 2 * moved[1, 2]
    assert (move(noises, 100.0, np.arange(2)) < moved).all()
    assert move(noises[1:], 1.0, np.array([1])) == pytest.approx(moved[1:])


def test_means_of_a_mixture_move_only_in_columns_that_it_predicts(examples):
    z, x = examples
    apart, together = (
        MixtureOfRegressors(5, shared=shared, shared_width=1.0).fit(z, x)
        for shared in (None, RidgeRegressor())
    )
    unseen = np.random.default_rng(1).random((20, 4))
    own, moved = (m.likely_components(unseen[0])[1][:-1] for m in (apart, together))
    estimated = RidgeRegressor().fit(z, x).predict(unseen[:1])[0]
    assert np.abs(moved[:, 0] - estimated[0]).max() < np.abs(own[:, 0] - estimated[0]).max()
    assert np.abs(moved[:, 1] - own[:, 1]).max() < 0.1 * np.abs(moved[:, 1] - estimated[1]).max()


def test_weights_are_the_densities_of_its_estimate_under_each_component():
    random = np.random.default_rng(0)
    estimated, means = random.normal(size=(5, 2)), random.normal(size=(5, 3, 2))
    noises, variances = random.random((3, 2)), random.random((3, 2))
    shared = SharedRegressor(RidgeRegressor(), variances)
    log_weights, _ = shared.product(estimated, means, noises, 2.0, np.arange(3))
    spread = np.sqrt(noises + 2 * variances)
    assert log_weights == pytest.approx(norm.logpdf(estimated[:, None], means, spread).sum(axis=2))


def test_it_moves_weight_between_components_and_none_to_the_background(examples):
    z, x = examples
    apart, together = (
        MixtureOfRegressors(5, shared=shared).fit(z, x) for shared in (None, RidgeRegressor())
    )
    own = apart.likely_components(z[0], least=0)[0]
    for temperature, moves in ((1e12, False), (1.0, True)):
        together.set_params(shared_temperature=temperature)
        weights = together.likely_components(z[0], least=0)[0]
        assert np.exp(weights[-1]) == pytest.approx(np.exp(own[-1]))
        assert (np.abs(weights - own).max() > 0.01) == moves
