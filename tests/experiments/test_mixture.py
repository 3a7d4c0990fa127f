import numpy as np
import pytest
from small_components import with_regression

from silpose.core.pose_space import ANGLES
from silpose.core.skeleton import ANGLES as NAMES
from silpose.experiments.mixture import BEST_OF, best_of, reliability_of
from silpose.recording.captions import in_words
from silpose.regression import Candidates, MixtureOfRegressors


@pytest.fixture(scope="module")
def mixture(run, longer_walkers):
    return run("mixture", longer_walkers, gmr=[1, 2])


def test_the_best_of_more_modes_is_better(mixture):
    error = mixture.values("mean_angular_error_deg")
    for method in ("mixture", "neighbours", "gmr"):
        names = [f"{method}_top1", *(f"{method}_best{k}" for k in BEST_OF[1:])]
        errors = [error[name] for name in names]
        assert errors == sorted(errors, reverse=True)
    assert error["mixture_best4"] < error["mean_pose"]


def test_densities_are_measured_by_their_likelihood(mixture):
    likelihood = mixture.values("log_likelihood")
    assert set(likelihood) == {"ridge", "mixture_top1", "gmr_top1"}
    assert np.isfinite(list(likelihood.values())).all()


def test_the_headline_is_the_negative_likelihood_of_what_was_chosen(mixture):
    name = "validation_log_likelihood"
    tried = {row["clusters"]: row[name] for row in mixture.rows if name in row}
    assert set(tried) == {10, 20}
    assert -mixture.result.headline in tried.values()
    assert -mixture.result.headline >= max(tried.values())


def test_the_figure_has_a_curve_for_each_method_with_modes(mixture):
    errors, likelihoods, _ = mixture.result.figure.axes
    labels = [line.get_label() for line in errors.lines]
    modes = ["modes: mixture", "modes: neighbours", "modes: Gaussian mixture"]
    assert labels == [*modes, *map(in_words, ("ridge", "knn", "oracle"))]
    assert len(likelihoods.patches) == 3


def test_without_components_gaussian_mixture_regression_is_left_out(run, walkers):
    plain = with_regression(
        walkers, mixture=Candidates(MixtureOfRegressors(10, temperature=8, noise_width=2))
    )
    metrics = run("mixture", plain, record=False, gmr=[]).metrics
    assert not any(method.startswith("gmr") for method in metrics)


@pytest.mark.slow
def test_on_the_authors_data_the_mixture_reaches_what_is_claimed(run, authors):
    chosen = MixtureOfRegressors(  # what validation chooses
        60,
        temperature=16,
        noise_width=4,
        shared_width=16,
        shared_temperature=256,
        calibration_exponent=0.7,
    )
    components = with_regression(authors, mixture=Candidates(chosen))
    ran = run("mixture", components, record=False, gmr=[1])
    error, likelihood = ran.values("mean_joint_distance"), ran.values("log_likelihood")
    assert error["mixture_top1"] <= error["ridge"]
    assert error["mixture_best4"] < min(1.75, error["neighbours_best4"])
    assert max(likelihood, key=likelihood.get) == "mixture_top1"
    assert ran.metrics["mixture_top1"]["calibration_error"] < 0.1


def walker(left, right):
    angles = np.zeros((1, 54))
    angles[:, NAMES.index("left_hip_x")], angles[:, NAMES.index("right_hip_x")] = left, right
    return ANGLES.from_angles(angles)


def test_the_nearest_of_the_first_modes_is_chosen():
    x = walker(20, -20)
    modes = np.stack([walker(0, 0), walker(-20, 20), walker(19, -19)] + 5 * [walker(90, 90)], 1)
    best = best_of(ANGLES, {"some": modes}, x)
    np.testing.assert_array_equal(best["some_top1"], walker(0, 0))
    np.testing.assert_array_equal(best["some_best2"], walker(0, 0))
    np.testing.assert_array_equal(best["some_best4"], walker(19, -19))


def test_reliability_counts_how_often_a_mode_is_nearest():
    poses = np.concatenate([walker(20, -20), walker(-20, 20)])
    means = np.tile(poses, (100, 1, 1))
    weights = np.tile([0.7, 0.3], (100, 1))
    x = np.concatenate([np.repeat(poses[:1], 80, axis=0), np.repeat(poses[1:], 20, axis=0)])
    rows = reliability_of(ANGLES, weights, means, x)
    assert [row["weight"] for row in rows] == pytest.approx([0.3, 0.7])
    assert [row["nearest"] for row in rows] == pytest.approx([0.2, 0.8])
    assert [row["modes"] for row in rows] == [100, 100]
