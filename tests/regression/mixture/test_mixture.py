import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.linear_model import Ridge
from sklearn.utils.estimator_checks import parametrize_with_checks

from silpose.core.errors import InputError
from silpose.regression import MixtureOfRegressors, choose_mixture, normalised
from silpose.regression.mixture.experts import Prior, expectation_maximisation
from silpose.regression.mixture.local_clusters import local_clusters
from silpose.regression.selection.mixtures import MixtureSettings


def two_valued(n, seed=0):
    """Inputs (n, 3), and outputs (n, 2) on one of two branches, which the inputs do not tell."""
    rng = np.random.default_rng(seed)
    z = rng.uniform(-1, 1, (n, 3))
    branch = rng.random(n) < 0.7
    x = np.where(branch[:, None], 3.0, -3.0) + 0.5 * z[:, :2] + 0.05 * rng.normal(size=(n, 2))
    return z, x, branch


@pytest.fixture(scope="module")
def mixture():
    z, x, _ = two_valued(600)
    return MixtureOfRegressors(4, temperature=1.0, damping=0.1, floor=0.01).fit(z, x)


def test_gives_both_answers_with_their_probabilities(mixture):
    z, x, branch = two_valued(300, seed=1)
    weights, means, variances = mixture.predict_modes(z, 2)
    both = np.stack([3 + 0.5 * z[:, :2], -3 + 0.5 * z[:, :2]], axis=1)
    assert np.abs(means - both).max() < 0.3
    assert weights[:, 0].mean() == pytest.approx(0.7, abs=0.08)
    assert (weights.sum(axis=1) <= 1 + 1e-9).all()
    assert np.sqrt(variances).mean() < 0.3
    nearest = np.linalg.norm(x[:, None] - means, axis=2).argmin(axis=1)
    assert ((nearest == 0) == branch).mean() > 0.99


def test_the_mode_is_an_answer_and_the_mean_is_none(mixture):
    z, _, _ = two_valued(50, seed=2)
    mode = mixture.predict(z)
    mean = mixture.set_params(answer="mean").predict(z)
    mixture.set_params(answer="mode")
    assert np.abs(mode).min() > 2
    assert np.abs(mean).mean() < 2


def test_samples_come_from_both(mixture):
    z, _, _ = two_valued(20, seed=3)
    drawn = mixture.sample(z, 400, seed=0)
    assert drawn.shape == (20, 400, 2)
    assert (drawn[..., 0] > 0).mean() == pytest.approx(0.7, abs=0.08)
    assert mixture.sample(z, 2, seed=5) == pytest.approx(mixture.sample(z, 2, seed=5))


def test_its_density_integrates_to_one():
    z, x, _ = two_valued(400)
    mixture = MixtureOfRegressors(3, floor=0.05).fit(z, x[:, 0])
    grid = np.linspace(-40, 40, 4001)
    density = np.exp(mixture.log_likelihoods(np.repeat(z[:1], len(grid), axis=0), grid))
    step = (grid[1] - grid[0]) / mixture.scale_[0]
    assert density.sum() * step == pytest.approx(1, abs=1e-3)


def test_em_does_not_lose_likelihood_between_prunings():
    z, x, _ = two_valued(500)
    mixture = MixtureOfRegressors(40, smallest=8, max_iter=40, tol=1e-9).fit(z, x)
    steps = np.diff(mixture.objective_)
    unpruned = [k for k in range(len(steps)) if k + 1 not in mixture.pruned_]
    assert len(unpruned) > 5
    assert steps[unpruned].min() > -1e-7


def test_starved_components_are_pruned():
    z, x, branch = two_valued(300)
    labels = np.where(branch, 1, 0)
    labels[:3] = 2
    prior = Prior(5.0, np.ones(3), np.ones(2), 1.0, 0.1)
    experts, _, pruned = expectation_maximisation(z, x, labels, prior, 10.0, 30, 1e-9)
    assert len(pruned) == 1
    assert sorted(np.sign(experts.offsets[:, 0])) == [-1, 1]


def test_one_component_is_the_single_regressor():
    z, x, _ = two_valued(200)
    single = MixtureOfRegressors(1, smallest=200, damping=2.0).fit(z, x)
    psi = single.reduction_.transform(z)
    assert single.components_ == 1
    assert single.predict(z) == pytest.approx(Ridge(2.0).fit(psi, x).predict(psi))


def test_far_from_training_it_doubts(mixture):
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
    mixture = MixtureOfRegressors(4, temperature=1.0, damping=0.1, floor=0.02).fit(z, x)
    _, means, _ = mixture.predict_modes(z, 2)
    heading = np.rad2deg(np.arctan2(means[..., 1], means[..., 0]))
    off = (heading - theta[:, None] + 180) % 360 - 180
    assert np.abs(off).min(axis=1).max() < 5
    assert np.linalg.norm(means, axis=2).min() > 0.95


def test_clusters_are_split_where_poses_are_not_connected():
    z, x, branch = two_valued(300)
    labels = local_clusters(z, x, 3, 5, 0)
    assert set(np.unique(labels)) == set(range(labels.max() + 1))
    for label in range(labels.max() + 1):
        assert len(set(branch[labels == label])) == 1


def test_identical_examples_and_constant_outputs_are_answered():
    z, x = np.ones((30, 4)), np.tile([1.0, 2.0], (30, 1))
    mixture = MixtureOfRegressors(5).fit(z, x)
    assert mixture.predict(z) == pytest.approx(x)
    assert mixture.log_likelihoods(z, x) == pytest.approx(np.zeros(30))  # nothing varies


@given(st.integers(0, 2**32 - 1), st.floats(-3, 3))
@settings(max_examples=25, deadline=None)
def test_any_input_has_finite_answers(mixture, seed, size):
    z = 10.0**size * np.random.default_rng(seed).standard_normal((6, 3))
    weights, means, variances = mixture.predict_modes(z, 3)
    assert np.isfinite(weights).all()
    assert np.isfinite(means).all()
    assert (variances > 0).all()
    assert (np.diff(weights, axis=1) <= 1e-12).all()
    shares = normalised(weights).sum(axis=1)
    assert np.minimum(np.abs(shares - 1), shares) == pytest.approx(np.zeros(6))


def test_what_it_cannot_do_it_says(mixture):
    z, x, _ = two_valued(20)
    with pytest.raises(InputError, match="30 clusters want as many examples, and n_samples = 20"):
        MixtureOfRegressors(30).fit(z, x)
    with pytest.raises(InputError, match="negative inputs"):
        MixtureOfRegressors(2, hellinger=True).fit(z, x)
    with pytest.raises(InputError, match="no answer 'best'"):
        MixtureOfRegressors(2, answer="best").fit(z, x)
    with pytest.raises(InputError, match="at least one mode"):
        mixture.predict_modes(z, 0)
    for wrong in ({"damping": 0}, {"temperature": -1}, {"doubt": 1.0}, {"dimensions": 0}):
        with pytest.raises(InputError, match=next(iter(wrong))):
            MixtureOfRegressors(2, **wrong).fit(z, x)


def test_settings_are_chosen_by_held_out_likelihood():
    sequences = [two_valued(150, seed)[:2] for seed in range(3)]
    settings = MixtureSettings(
        [1, 4], temperature=1.0, noise_width=[1.0, 4.0], sharpness=[0.5, 1.0], hellinger=False
    )

    def distance(x, other):
        return np.linalg.norm(x - other, axis=-1)

    chosen, rows = choose_mixture(sequences, [], settings, np.ones(2), distance)
    best = max(rows, key=lambda row: row["validation_log_likelihood"])
    assert (chosen.clusters, chosen.noise_width) == (best["clusters"], best["noise_width"])
    assert len(rows) == 4


@parametrize_with_checks([MixtureOfRegressors(2, max_iter=3)])
def test_is_a_scikit_learn_estimator(estimator, check):
    check(estimator)
