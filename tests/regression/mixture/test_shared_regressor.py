import numpy as np
import pytest
from scipy.stats import norm

from silpose.regression import MixtureOfRegressors, RidgeRegressor
from silpose.regression.mixture.serialisation import mixture_from, mixture_state
from silpose.regression.mixture.shared_regressor import SharedRegressor


@pytest.fixture
def examples():
    random = np.random.default_rng(0)
    z = random.random((300, 4))
    x = np.column_stack([z.sum(axis=1), random.choice([-1.0, 1.0], 300)])
    return z, x + 0.01 * random.standard_normal(x.shape)


def test_is_heeded_where_it_errs_little(examples):
    z, x = examples
    shares = np.column_stack([x[:, 0] < 2, x[:, 0] >= 2]).astype(float)
    x = np.column_stack([x, np.where(x[:, 0] < 2, 0.0, x[:, 1])])  # hard to tell beyond 2 only
    shared = SharedRegressor.fit(RidgeRegressor(), z, x, shares)
    noises = np.full((2, 3), 0.05)

    def heeded(noises, width, which):  # how far an answer of 0 moves towards 1
        return shared.product(np.ones((1, 3)), np.zeros((1, len(which), 3)), noises, width, which)[
            1
        ][0]

    heed = heeded(noises, 1.0, np.arange(2))
    assert (heed[:, 0] > 0.9).all() and (heed[:, 1] < 0.1).all()
    assert heed[0, 2] > 2 * heed[1, 2]
    assert (heeded(noises, 100.0, np.arange(2)) < heed).all()
    assert heeded(noises[1:], 1.0, np.array([1])) == pytest.approx(heed[1:])


def test_answers_move_towards_it_between_its_estimate_and_their_own(examples):
    z, x = examples
    apart, together = (
        MixtureOfRegressors(5, shared=shared, shared_width=1.0).fit(z, x)
        for shared in (None, RidgeRegressor())
    )
    unseen = np.random.default_rng(1).random((20, 4))
    own, moved = (m.answers(unseen[0])[1][:-1] for m in (apart, together))
    said = RidgeRegressor().fit(z, x).predict(unseen[:1])[0]
    assert np.abs(moved[:, 0] - said[0]).max() < np.abs(own[:, 0] - said[0]).max()
    assert np.abs(moved[:, 1] - own[:, 1]).max() < 0.1 * np.abs(moved[:, 1] - said[1]).max()
    restored = mixture_from(mixture_state(together))
    assert restored.predict(unseen) == pytest.approx(together.predict(unseen))


def test_tells_how_likely_its_estimate_is_if_a_component_is_right():
    random = np.random.default_rng(0)
    said, means = random.normal(size=(5, 2)), random.normal(size=(5, 3, 2))
    noises, variances = random.random((3, 2)), random.random((3, 2))
    shared = SharedRegressor(RidgeRegressor(), variances)
    told, _ = shared.product(said, means, noises, 2.0, np.arange(3))
    spread = np.sqrt(noises + 2 * variances)
    assert told == pytest.approx(norm.logpdf(said[:, None], means, spread).sum(axis=2))


def test_moves_weight_between_components_and_none_to_their_doubt(examples):
    z, x = examples
    apart, together = (
        MixtureOfRegressors(5, shared=shared).fit(z, x) for shared in (None, RidgeRegressor())
    )
    own = apart.answers(z[0], least=0)[0]
    for temperature, moves in ((1e12, False), (1.0, True)):
        weights = together.set_params(shared_temperature=temperature).answers(z[0], least=0)[0]
        assert np.exp(weights[-1]) == pytest.approx(np.exp(own[-1]))
        assert (np.abs(weights - own).max() > 0.01) == moves
