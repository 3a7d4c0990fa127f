import joblib
import numpy as np
import pytest
from sklearn.base import clone

from silpose.core.errors import InputError
from silpose.regression import (
    Basis,
    Candidates,
    RegressionCandidates,
    RelevanceVectorRegressor,
    RidgeRegressor,
    SupportVectorRegressor,
    choose_regressors,
)
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.selection import regressor_search

METHODS = ("ridge", "rvm", "rvm_10", "svm")


@pytest.fixture(scope="module")
def candidates():
    return RegressionCandidates(
        Candidates(Basis(), {"width": [0.5, 4.0]}),
        Candidates(RidgeRegressor(), {"damping": [0.01, 1.0]}),
        Candidates(RelevanceVectorRegressor(), {"nu": [0.8, 0.05, 0.2]}),
        Candidates(SupportVectorRegressor(), {"penalty": [0.1, 3.0]}),
        slack=0.1,
    )


@pytest.fixture(scope="module")
def chosen(candidates, smooth, error):
    train, validation = smooth
    return choose_regressors(candidates, METHODS, [train], [validation], error, units=0.05)


def rows_of(chosen, method):
    return [row for row in chosen.rows if row["method"] == method]


def test_ridge_is_the_best_on_validation(chosen, smooth, error):
    _, (z, x) = smooth
    rows = rows_of(chosen, "ridge")
    assert len(rows) == 4
    best = min(rows, key=lambda row: row["validation_error"])
    ridge = chosen.regressors["ridge"]
    assert (ridge.basis.width, ridge.damping) == (best["width"], best["damping"])
    assert error(x, ridge.predict(z)) == best["validation_error"]


def test_rvm_is_the_sparsest_within_the_slack(chosen):
    rows = rows_of(chosen, "rvm")
    assert [row["nu"] for row in rows] == [0.05, 0.2, 0.8]
    bound = 1.1 * min(row["validation_error"] for row in rows)
    good = [row["kept"] for row in rows if row["validation_error"] <= bound]
    assert chosen.regressors["rvm"].kept_ == min(good)


def test_rvm_n_keeps_at_most_n_percent(chosen):
    assert chosen.regressors["rvm_10"].kept_ == 0.10
    assert rows_of(chosen, "rvm_10") == []  # nothing was to be chosen


def test_the_width_that_ridge_chose_serves_all_methods(chosen):
    widths = {regressor.basis.width for regressor in chosen.regressors.values()}
    assert widths == {chosen.regressors["ridge"].basis.width}


def test_the_tube_of_the_svm_is_in_the_units_given(chosen):
    assert len(rows_of(chosen, "svm")) == 2
    assert chosen.regressors["svm"].units == 0.05


@pytest.mark.parametrize("method", METHODS)
def test_chosen_regressors_are_those_fitted_with_their_parameters(chosen, smooth, method):
    (z, x), (unseen, _) = smooth
    regressor = chosen.regressors[method]
    again = clone(regressor).fit(z, x)
    if method == "rvm":  # its path began at a smaller ν
        assert len(again.relevance_) == pytest.approx(len(regressor.relevance_), abs=3)
    else:
        np.testing.assert_allclose(again.predict(unseen), regressor.predict(unseen))


@pytest.mark.parametrize("method", METHODS)
def test_the_validation_error_of_each_method_is_known(chosen, smooth, error, method):
    _, (z, x) = smooth
    expected = error(x, chosen.regressors[method].predict(z))
    assert chosen.validation_error(method) == expected


def test_only_and_all_methods_asked_for_in_their_order(candidates, smooth, error):
    train, validation = smooth
    only = choose_regressors(candidates, ["rvm_50", "rvm_20"], [train], [validation], error)
    assert list(only.regressors) == ["rvm_50", "rvm_20"]
    assert only.rows == []
    assert only.regressors["rvm_20"].kept_ <= 0.2 < only.regressors["rvm_50"].kept_ <= 0.5


def test_every_name_of_a_grid_is_chosen(smooth, error):
    train, validation = smooth
    candidates = RegressionCandidates(
        Candidates(Basis(), {"normalised": [True, False]}),
        Candidates(RidgeRegressor()),
        Candidates(RelevanceVectorRegressor(nu=0.1), {"tol": [1e-2, 1e-4]}),
    )
    chosen = choose_regressors(candidates, ["ridge", "rvm", "rvm_10"], [train], [validation], error)
    assert [row["normalised"] for row in rows_of(chosen, "ridge")] == [True, False]
    for method in ("rvm", "rvm_10"):
        assert [row["tol"] for row in rows_of(chosen, method)] == [1e-2, 1e-4]


def test_without_kernels_widths_make_no_difference(candidates, smooth, error):
    train, validation = smooth
    linear = Candidates(Basis(None, linear=True), {"width": [1.0, 2.0]})
    chosen = choose_regressors(
        RegressionCandidates(linear, candidates.ridge), ["ridge"], [train], [validation], error
    )
    assert [(row["width"], row["damping"]) for row in chosen.rows] == [(1.0, 0.01), (1.0, 1.0)]


def test_without_validation_takes_training_takes_are_held_out(candidates, takes, smooth, error):
    _, (z, x) = smooth
    chosen = choose_regressors(candidates, ["ridge", "rvm", "svm"], takes, [], error)
    ridge = chosen.regressors["ridge"]
    assert len(ridge.relevance_) == 200  # fitted to all of them in the end
    assert error(x, ridge.predict(z)) < 0.2
    errors = []
    for k, (held_z, held_x) in enumerate(takes):
        z_train, x_train = (
            np.concatenate([take[i] for j, take in enumerate(takes) if j != k]) for i in (0, 1)
        )
        fitted = RidgeRegressor(ridge.basis, damping=ridge.damping).fit(z_train, x_train)
        errors.append(error(held_x, fitted.predict(held_z)))
    expected = np.exp(np.log(errors).mean())
    assert chosen.validation_error("ridge") == pytest.approx(expected)
    with pytest.raises(InputError, match="needs a validation take"):
        choose_regressors(candidates, ["ridge"], takes[:1], [], error)


def test_frames_are_thinned_and_groups_held_out_together(takes, error, monkeypatch):
    monkeypatch.setattr(regressor_search, "_FRAMES", 100)
    groups = ["a", "b", "a", "c", "b"]
    held_out = regressor_search.HeldOut(Candidates(Basis()), error, takes, [], groups)
    assert [fold.frames for fold in held_out.folds] == [40, 40, 20]
    for fold in held_out.folds:
        assert len(fold.z) + fold.frames == 100
        assert not {tuple(row) for row in fold.z} & {tuple(row) for row in fold.z_validation}


@pytest.mark.parametrize("validated", [True, False])
def test_kernel_matrices_are_computed_once_for_each_width_and_fold(
    candidates, takes, smooth, error, validated, monkeypatch
):
    sizes = []
    of = NormalEquations.of
    monkeypatch.setattr(NormalEquations, "of", lambda f, y: sizes.append(f.shape) or of(f, y))
    validation = [smooth[1]] if validated else []
    choose_regressors(candidates, ["ridge", "rvm", "rvm_10", "rvm_20"], takes, validation, error)
    if validated:
        assert sizes == [(200, 200)] * 2
    else:  # every fold for each width, then with the best one for the RVM, and all takes
        assert sorted(sizes) == [(160, 160)] * (5 * 2 + 5) + [(200, 200)]


def test_side_by_side_it_chooses_the_same(candidates, takes, error):
    methods = ["ridge", "rvm", "rvm_20", "svm"]
    alone = choose_regressors(candidates, methods, takes, [], error, units=0.05)
    with joblib.parallel_config(n_jobs=2):
        together = choose_regressors(candidates, methods, takes, [], error, units=0.05)
    assert together.rows == alone.rows
    for method in methods:
        np.testing.assert_array_equal(
            together.regressors[method].coef_, alone.regressors[method].coef_
        )


def test_wrong_names_and_slacks_are_refused_at_once(candidates, takes, error):
    with pytest.raises(InputError, match="no method 'svn'"):
        choose_regressors(candidates, ["ridge", "svn"], takes, [], error)
    with pytest.raises(InputError, match=r"slack must be zero or positive, not -0.1"):
        RegressionCandidates(slack=-0.1)
