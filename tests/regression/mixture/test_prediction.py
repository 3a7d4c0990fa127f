from copy import copy

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.exceptions import NotFittedError

from silpose.core.errors import InputError
from silpose.regression import MixtureOfRegressors, normalised


def test_both_branches_are_modes_with_their_probabilities(mixture, two_valued):
    z, x, branch = two_valued(300, seed=1)
    weights, means, variances = mixture.predict_modes(z, 2)
    both = np.stack([3 + 0.5 * z[:, :2], -3 + 0.5 * z[:, :2]], axis=1)
    assert np.abs(means - both).max() < 0.3
    assert weights[:, 0].mean() == pytest.approx(0.7, abs=0.08)
    assert (weights.sum(axis=1) <= 1 + 1e-9).all()
    assert np.sqrt(variances).mean() < 0.3
    nearest = np.linalg.norm(x[:, None] - means, axis=2).argmin(axis=1)
    assert ((nearest == 0) == branch).mean() > 0.99


def test_the_mode_lies_on_a_branch_and_the_mean_on_none(mixture, two_valued):
    z, _, _ = two_valued(50, seed=2)
    mode = mixture.predict(z)
    mean = copy(mixture).set_params(point_estimate="mean").predict(z)
    assert np.abs(mode).min() > 2
    assert np.abs(mean).mean() < 2


def test_samples_come_from_both_branches(mixture, two_valued):
    z, _, _ = two_valued(20, seed=3)
    drawn = mixture.sample(z, 400, seed=0)
    assert drawn.shape == (20, 400, 2)
    assert (drawn[..., 0] > 0).mean() == pytest.approx(0.7, abs=0.08)
    assert mixture.sample(z, 2, seed=5) == pytest.approx(mixture.sample(z, 2, seed=5))


def test_the_density_integrates_to_one(two_valued):
    z, x, _ = two_valued(400)
    mixture = MixtureOfRegressors(3, hellinger=False, floor=0.05).fit(z, x[:, 0])
    grid = np.linspace(-40, 40, 4001)
    density = np.exp(mixture.log_likelihoods(np.repeat(z[:1], len(grid), axis=0), grid))
    step = (grid[1] - grid[0]) / mixture.scale_[0]
    assert density.sum() * step == pytest.approx(1, abs=1e-3)


def test_far_from_training_the_background_takes_over(mixture):
    near, far = np.zeros((1, 3)), np.full((1, 3), 40.0)
    assert mixture.predict_modes(near, 2)[0].sum() > 0.9
    assert mixture.predict_modes(far, 2)[0].sum() < 0.1
    spread = [mixture.sample(z, 500, seed=0).std(axis=1).min() for z in (near, far)]
    assert spread[1] > 0.8 * mixture.scale_.min()


def test_a_heading_is_never_averaged_across_the_circle():
    rng = np.random.default_rng(0)
    z = rng.uniform(-1, 1, (400, 2))
    theta = np.where(rng.random(400) < 0.5, 170, -20) + 15 * z[:, 0]  # past 180 and back at -180
    x = np.stack([np.cos(np.deg2rad(theta)), np.sin(np.deg2rad(theta))], axis=1)
    mixture = MixtureOfRegressors(4, hellinger=False, temperature=1.0, damping=0.1, floor=0.02).fit(
        z, x
    )
    _, means, _ = mixture.predict_modes(z, 2)
    heading = np.rad2deg(np.arctan2(means[..., 1], means[..., 0]))
    off = (heading - theta[:, None] + 180) % 360 - 180
    assert np.abs(off).min(axis=1).max() < 5
    assert np.linalg.norm(means, axis=2).min() > 0.95


@given(st.integers(0, 2**32 - 1), st.floats(-3, 3))
@settings(max_examples=25, deadline=None)
def test_any_input_has_finite_modes(mixture, seed, size):
    z = 10.0**size * np.random.default_rng(seed).standard_normal((6, 3))
    weights, means, variances = mixture.predict_modes(z, 3)
    assert np.isfinite(weights).all()
    assert np.isfinite(means).all()
    assert (variances > 0).all()
    assert (np.diff(weights, axis=1) <= 1e-12).all()
    shares = normalised(weights).sum(axis=1)
    assert np.minimum(np.abs(shares - 1), shares) == pytest.approx(np.zeros(6))


def test_likely_components_are_the_components_without_their_shares(mixture, two_valued):
    z = two_valued(1, seed=4)[0][0]
    log_weights, means, variances = mixture.likely_components(z, least=0.0)
    assert len(log_weights) == mixture.components_ + 1
    assert variances == pytest.approx(mixture.variances())
    shares = np.append(mixture.experts_.log_shares, mixture.experts_.log_shares.mean())
    weights = np.exp(log_weights + shares)
    mean = copy(mixture).set_params(point_estimate="mean").predict(z[None])[0]
    assert weights / weights.sum() @ means == pytest.approx(mean)
    few = mixture.likely_components(z, least=0.5)
    assert len(few[0]) <= len(log_weights)
    assert few[1][-1] == pytest.approx(mixture.mean_)  # the background is always last


def test_the_calibration_exponent_changes_weights_but_neither_sum_nor_modes(mixture, two_valued):
    z, _, _ = two_valued(40, seed=5)
    plain = mixture.predict_modes(z, 8)
    sharp = copy(mixture).set_params(calibration_exponent=2.0).predict_modes(z, 8)
    assert sharp[0].sum(axis=1) == pytest.approx(plain[0].sum(axis=1))
    assert (sharp[0][:, 0] >= plain[0][:, 0]).all()
    assert sharp[0][:, 0].mean() > plain[0][:, 0].mean() + 0.01
    assert sharp[1] == pytest.approx(plain[1])


def test_score_is_the_mean_log_likelihood(mixture, two_valued):
    z, x, _ = two_valued(30, seed=6)
    likelihoods = mixture.log_likelihoods(z, x)
    assert mixture.score(z, x) == pytest.approx(likelihoods.mean())
    weight = np.arange(30)
    assert mixture.score(z, x, weight) == pytest.approx(np.average(likelihoods, weights=weight))


def test_misuse_is_refused(mixture):
    with pytest.raises(InputError, match="number of modes must be 1 or more, not 0"):
        mixture.predict_modes(np.zeros((1, 3)), 0)
    with pytest.raises(NotFittedError):
        MixtureOfRegressors().predict_modes(np.zeros((1, 3)), 1)


@pytest.mark.parametrize("outliers", [0.01, 0.0])
@pytest.mark.parametrize("dimensions", [1, 2, 6])
def test_far_from_the_data_it_gives_way_to_the_mean_and_its_variance(outliers, dimensions):
    rng = np.random.default_rng(0)
    z = rng.random((300, dimensions))
    x = z[:, 0] + 0.05 * rng.random(300)
    mixture = MixtureOfRegressors(10, outlier_probability=outliers, hellinger=False).fit(z, x)
    for distance in (3.0, 30.0, 3e3, 1e8, -3.0, -1e8):
        far = np.full((1, dimensions), distance)
        assert abs(mixture.predict(far)[0] - 0.5) < 1.5
    variances = mixture.predict_modes(np.full((1, dimensions), 3e3), 1)[2]
    np.testing.assert_allclose(variances, x.var(), rtol=0.01)
    assert abs(mixture.predict(np.full((1, dimensions), 1e8))[0] - x.mean()) < 0.01


def test_few_examples_for_its_components_bring_a_warning():
    z = np.random.default_rng(0).random((100, 5))
    with pytest.warns(UserWarning, match="100 examples are few for clusters=60"):
        MixtureOfRegressors().fit(z, z[:, 0])
