from copy import copy

import joblib
import numpy as np
import pytest
from sklearn.base import clone

from silpose.regression import (
    Basis,
    Candidates,
    MixtureOfRegressors,
    RidgeRegressor,
    choose_mixture,
    normalised,
)

LIKELIHOOD = "validation_log_likelihood"
GRID = {
    "clusters": [1, 4],
    "noise_width": [1.0, 4.0],
    "shared_width": [1.0, 8.0],
    "shared_temperature": [16.0, 64.0],
    "calibration_exponent": [0.5, 1.0, 2.0],
}


def distance(x, other):
    return np.linalg.norm(x - other, axis=-1)


@pytest.fixture(scope="module")
def branches():
    """Three takes whose poses are on one of two branches, which the inputs do not show."""
    takes = []
    for seed in range(3):
        rng = np.random.default_rng(seed)
        z = rng.uniform(-1, 1, (120, 3))
        branch = rng.random(120) < 0.7
        x = np.where(branch[:, None], 3.0, -3.0) + 0.5 * z[:, :2]
        takes.append((z, x + 0.05 * rng.normal(size=(120, 2))))
    return takes


def choose(train, validation=(), grid=GRID, shared=True, **more):
    candidates = Candidates(MixtureOfRegressors(temperature=1.0, hellinger=False), grid)
    ridge = RidgeRegressor(Basis(hellinger=False)) if shared else None
    return choose_mixture(
        candidates, train, validation, units=np.ones(2), distance=distance, shared=ridge, **more
    )


@pytest.fixture(scope="module")
def chosen(branches):
    return choose(branches)


@pytest.fixture(scope="module")
def validated(branches):
    return choose(branches[:2], branches[2:])


def stage(chosen, name):
    return [row for row in chosen.rows if name in row]


def test_each_stage_begins_with_the_best_of_the_one_before(chosen):
    first = [row for row in chosen.rows if "shared_width" not in row]
    assert [(row["clusters"], row["noise_width"]) for row in first] == [
        (1, 1.0), (1, 4.0), (4, 1.0), (4, 4.0),
    ]  # fmt: skip
    clusters = max(first, key=lambda row: row[LIKELIHOOD])["clusters"]
    widths = [r for r in stage(chosen, "shared_width") if "shared_temperature" not in r]
    assert [(r["clusters"], r["noise_width"], r["shared_width"]) for r in widths] == [
        (clusters, n, s) for n in (1.0, 4.0) for s in (1.0, 8.0)
    ]
    best = max(widths, key=lambda row: row[LIKELIHOOD])
    warm = [r for r in stage(chosen, "shared_temperature") if "calibration_exponent" not in r]
    assert {(r["noise_width"], r["shared_width"]) for r in warm} == {
        (best["noise_width"], best["shared_width"])
    }
    last = max(warm, key=lambda row: row[LIKELIHOOD])
    assert chosen.log_likelihood == last[LIKELIHOOD]
    names = ("clusters", "noise_width", "shared_width", "shared_temperature")
    assert {name: getattr(chosen.mixture, name) for name in names} == {
        name: last[name] for name in names
    }


def test_the_exponent_is_that_of_the_best_brier_score(chosen):
    rows = stage(chosen, "calibration_exponent")
    assert [row["calibration_exponent"] for row in rows] == [0.5, 1.0, 2.0]
    best = min(rows, key=lambda row: row["validation_brier_score"])
    assert chosen.mixture.calibration_exponent == best["calibration_exponent"]


def test_scores_are_those_of_the_mixtures_of_the_folds(chosen):
    folds, mixtures = zip(*chosen.by_fold, strict=True)
    likelihoods = [
        mixture.log_likelihoods(fold.z_validation, fold.x_validation).mean()
        for fold, mixture in zip(folds, mixtures, strict=True)
    ]
    frames = [fold.frames for fold in folds]
    assert chosen.log_likelihood == pytest.approx(np.average(likelihoods, weights=frames))
    for row in stage(chosen, "calibration_exponent"):
        scores = []
        for fold, mixture in chosen.by_fold:
            own = copy(mixture).set_params(calibration_exponent=row["calibration_exponent"])
            weights, means, _ = own.predict_modes(fold.z_validation, 8)
            distances = np.where(weights > 0, distance(fold.x_validation[:, None], means), np.inf)
            truth = np.arange(8) == distances.argmin(axis=1)[:, None]
            scores.append(((normalised(weights) - truth) ** 2).sum(axis=1).mean())
        expected = np.exp(np.average(np.log(scores), weights=frames))
        assert row["validation_brier_score"] == pytest.approx(expected)


def test_mixtures_of_folds_and_of_all_have_the_settings_chosen(chosen, branches):
    assert len(chosen.by_fold) == 3
    for fold, mixture in chosen.by_fold:
        again = clone(chosen.mixture).fit(fold.z, fold.x)
        np.testing.assert_allclose(again.predict(fold.z), mixture.predict(fold.z))
    z, x = (np.concatenate(part) for part in zip(*branches, strict=True))
    again = clone(chosen.mixture).fit(z, x)
    np.testing.assert_allclose(again.predict(z), chosen.mixture.predict(z))


def test_with_validation_takes_each_setting_is_fitted_once(branches, validated, monkeypatch):
    ((fold, mixture),) = validated.by_fold
    assert mixture is validated.mixture
    assert fold.train == branches[:2]
    fits = []
    fit = MixtureOfRegressors.fit_with
    monkeypatch.setattr(
        MixtureOfRegressors,
        "fit_with",
        lambda self, *args: fits.append(len(args[0])) or fit(self, *args),
    )
    choose(branches[:2], branches[2:])
    assert fits == [240, 240]  # the numbers of clusters; all else only changes predictions


def test_other_names_of_the_grid_are_chosen_in_the_first_stage(branches):
    grid = {"dimensions": [1, 3], "outlier_probability": [0.01, 0.1]}
    chosen = choose(branches[:2], branches[2:], grid, shared=False)
    rows = stage(chosen, LIKELIHOOD)
    assert [(r["dimensions"], r["outlier_probability"]) for r in rows] == [
        (1, 0.01), (1, 0.1), (3, 0.01), (3, 0.1),
    ]  # fmt: skip
    best = max(rows, key=lambda row: row[LIKELIHOOD])
    assert chosen.mixture.dimensions == best["dimensions"]


def test_groups_are_held_out_together(branches):
    chosen = choose(branches, grid={}, shared=False, groups=["a", "b", "a"])
    assert [fold.frames for fold, _ in chosen.by_fold] == [240, 120]


def test_side_by_side_it_chooses_the_same(branches, chosen):
    with joblib.parallel_config(n_jobs=2):
        together = choose(branches)
    assert together.rows == chosen.rows
    z = branches[0][0]
    np.testing.assert_array_equal(together.mixture.predict(z), chosen.mixture.predict(z))


def test_the_shared_regressor_is_fitted_once_a_fold(branches, monkeypatch):
    fitted, fit = [], RidgeRegressor.fit
    monkeypatch.setattr(
        RidgeRegressor, "fit", lambda self, z, x: fitted.append(len(z)) or fit(self, z, x)
    )
    choose(branches)
    assert sorted(fitted) == [240, 240, 240, 360]  # three folds, and all takes
