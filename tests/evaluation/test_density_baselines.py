import joblib
import numpy as np
import pytest
from scipy.stats import multivariate_normal

from silpose.core.errors import InputError
from silpose.evaluation.density_baselines import (
    GaussianMixtureRegression,
    SingleGaussian,
    choose_density_baseline,
    neighbour_modes,
)
from silpose.regression import Basis, Candidates, MixtureOfRegressors, RidgeRegressor

RIDGE = RidgeRegressor(Basis(None, linear=True), damping=0.01)
WIDTHS = [0.25, 1.0, 4.0, 64.0]


@pytest.fixture(scope="module")
def takes():
    """Takes of histograms (60, 4), and poses (60, 3) that they predict, the last one constant."""
    rng = np.random.default_rng(0)
    found = []
    for _ in range(3):
        z = rng.dirichlet(np.ones(4), 60)
        x = np.sqrt(z[:, :2]) @ np.array([[3.0, 1.0], [-1.0, 2.0]])
        x = np.column_stack([x + 0.1 * rng.normal(size=x.shape), np.full(60, 7.0)])
        found.append((z, x))
    return found


@pytest.fixture(scope="module")
def joined(takes):
    return tuple(np.concatenate(part) for part in zip(*takes, strict=True))


@pytest.fixture(scope="module")
def mixture(joined):
    return MixtureOfRegressors(2, dimensions=3, floor=0.01).fit(*joined)


def test_a_single_gaussian_has_the_variance_that_ridge_predicts(joined, mixture):
    z, x = joined
    baseline = SingleGaussian(RIDGE, width=2.0).fit(z, x, mixture)
    estimated, std = RIDGE.fit(z, x).predict(z, return_std=True)
    off = ((x - estimated) / mixture.scale_)[:5, :2]
    variance = 2.0 * ((std / mixture.scale_) ** 2)[:5, :2]
    expected = [
        multivariate_normal.logpdf(o, cov=np.diag(v)) for o, v in zip(off, variance, strict=True)
    ]
    assert baseline.log_likelihoods(z[:5], x[:5]) == pytest.approx(np.array(expected))


def test_one_joint_gaussian_is_linear_regression(joined, mixture):
    z, x = joined
    baseline = GaussianMixtureRegression(1).fit(z, x, mixture)
    psi = np.column_stack([mixture.reduction_.transform(z), np.ones(len(z))])
    expected = psi @ np.linalg.lstsq(psi, x, rcond=None)[0]
    modes = baseline.predict_modes(z, 1)
    assert modes.shape == (180, 1, 3)
    assert np.corrcoef(modes[:, 0, 0], expected[:, 0])[0, 1] > 0.99
    assert modes[:, 0, 2] == pytest.approx(np.full(180, 7.0))


@pytest.mark.parametrize("baseline", [SingleGaussian(RIDGE), GaussianMixtureRegression(2)])
def test_widths_widen_a_density(joined, mixture, baseline):
    z, x = joined
    fitted = baseline.fit(z, x, mixture)
    likelihoods = fitted.log_likelihoods_by_width(z, x, [1.0, 1e4])
    assert likelihoods.shape == (2, 180)
    assert likelihoods[0].mean() > likelihoods[1].mean()
    assert fitted.log_likelihoods(z, x) == pytest.approx(likelihoods[0])
    far = fitted.log_likelihoods_by_width(z, x + 5 * mixture.scale_, [1.0, 1e4])
    assert far[0].mean() < far[1].mean()


@pytest.mark.parametrize("validated", [True, False])
def test_the_settings_of_highest_held_out_likelihood_are_chosen(takes, joined, mixture, validated):
    train, validation = (takes[:2], takes[2:]) if validated else (takes, [])
    candidates = Candidates(SingleGaussian(RIDGE), {"width": WIDTHS})
    chosen = choose_density_baseline(candidates, train, validation, mixture)
    totals = np.zeros(len(WIDTHS))
    for k in [2] if validated else range(3):
        z, x = (np.concatenate([take[i] for j, take in enumerate(takes) if j != k]) for i in (0, 1))
        totals += SingleGaussian(RIDGE).fit(z, x, mixture).log_likelihoods_by_width(
            *takes[k], WIDTHS
        ).sum(axis=1)  # fmt: skip
    assert chosen.width == WIDTHS[totals.argmax()]
    z, x = (np.concatenate(part) for part in zip(*train, strict=True))
    again = SingleGaussian(RIDGE, width=chosen.width).fit(z, x, mixture)
    np.testing.assert_allclose(chosen.log_likelihoods(z, x), again.log_likelihoods(z, x))


def test_each_number_of_components_is_fitted_once_a_fold(takes, mixture, monkeypatch):
    fits = []
    fit = GaussianMixtureRegression.fit
    monkeypatch.setattr(
        GaussianMixtureRegression,
        "fit",
        lambda self, *data: fits.append(self.n_components) or fit(self, *data),
    )
    candidates = Candidates(GaussianMixtureRegression(), {"n_components": [1, 2], "width": WIDTHS})
    chosen = choose_density_baseline(candidates, takes, [], mixture)
    assert sorted(fits[:-1]) == [1, 1, 1, 2, 2, 2]
    assert fits[-1] == chosen.n_components
    with joblib.parallel_config(n_jobs=2):
        together = choose_density_baseline(candidates, takes, [], mixture)
    assert together.get_params() == chosen.get_params()


def test_wrong_parameters_are_refused():
    with pytest.raises(InputError, match="n_components must be a positive integer, not 0"):
        Candidates(GaussianMixtureRegression(0))
    with pytest.raises(InputError, match="width must be positive, not -1"):
        Candidates(SingleGaussian(), {"width": [1, -1]})


def test_neighbours_are_nearest_by_hellinger_distance(joined):
    z, x = joined
    found = neighbour_modes(z[:30], x[:30], z[30:40], 3)
    gaps = np.linalg.norm(np.sqrt(z[30:40, None]) - np.sqrt(z[None, :30]), axis=2)
    np.testing.assert_array_equal(found, x[:30][np.argsort(gaps, axis=1)[:, :3]])
    assert neighbour_modes(z[:2], x[:2], z[:1], 8).shape == (1, 2, 3)
