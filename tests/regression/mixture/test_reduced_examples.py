import numpy as np
import pytest

from silpose.core.parallel import engine
from silpose.regression import MixtureOfRegressors, RidgeRegressor
from silpose.regression.mixture.reduced_examples import among


@pytest.fixture(scope="module")
def examples():
    """Descriptors (900, 12), of which each has two poses (900, 4)."""
    rng = np.random.default_rng(0)
    z = rng.dirichlet(np.ones(12), 900)
    x = np.sqrt(z[:, :4]) * rng.choice([-9.0, 9.0], (900, 1)) + 0.1 * rng.normal(size=(900, 4))
    return z, x


def blocks_of(z, x):
    return [(z[k : k + 130], x[k : k + 130]) for k in range(0, len(z), 130)]


@pytest.mark.parametrize("shared", [None, RidgeRegressor()])
def test_blocks_give_what_all_in_one_go_does(examples, shared):
    """Components are pruned, too."""
    z, x = examples
    mixture = MixtureOfRegressors(8, dimensions=10, smallest=60, shared=shared, units=np.ones(4))
    one = mixture.fit(z, x)
    blocks = MixtureOfRegressors(**mixture.get_params(deep=False)).fit_blocks(blocks_of(z, x))
    assert blocks.pruned_ == one.pruned_
    assert blocks.objective_ == pytest.approx(one.objective_, rel=1e-9)
    assert blocks.background_ == pytest.approx(one.background_, rel=1e-9)
    for found, expected in zip(
        blocks.predict_modes(z[:50], 2), one.predict_modes(z[:50], 2), strict=True
    ):
        assert found == pytest.approx(expected, rel=1e-6, abs=1e-6)


def test_of_many_examples_some_say_where_to_start(examples, monkeypatch):
    monkeypatch.setattr("silpose.regression.mixture.mixture._SAMPLE", 300)
    z, x = examples
    one = MixtureOfRegressors(4, dimensions=10, max_iter=30).fit(z, x)
    with engine("joblib", n_jobs=2):
        sampled = MixtureOfRegressors(4, dimensions=10, max_iter=30).fit_blocks(blocks_of(z, x))
    assert sampled.n_features_in_ == 12
    means = [m.log_likelihoods(z, x).mean() for m in (one, sampled)]
    assert means[1] == pytest.approx(means[0], abs=0.5)


def test_responsibilities_of_pruned_components_go_to_the_others():
    shares = np.array([[0.2, 0.6, 0.2], [0.0, 1.0, 0.0]])
    expected = np.array([[0.5, 0.5], [0.5, 0.5]])
    assert among(shares, np.array([True, False, True])) == pytest.approx(expected)
