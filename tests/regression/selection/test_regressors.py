import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.regression import (
    BasisSettings,
    Candidates,
    RidgeSettings,
    RvmSettings,
    check_methods,
)


def mean_error(true, estimated):
    return np.abs(true - estimated).mean()


@pytest.fixture(scope="module")
def candidates():
    return Candidates(
        BasisSettings(width=[0.5, 4.0]),
        RidgeSettings(damping=[0.01, 1.0]),
        RvmSettings(nu=[0.05, 0.2, 0.8], slack=0.1),
    )


@pytest.fixture(scope="module")
def chosen(candidates, smooth):
    train, validation = smooth
    return candidates.choose(["ridge", "rvm", "rvm_10"], [train], [validation], mean_error)


def test_ridge_is_the_best_on_validation(chosen, smooth):
    _, (z, x) = smooth
    tried = [row for row in chosen.rows if row["method"] == "ridge"]
    assert len(tried) == 4
    best = min(tried, key=lambda row: row["validation_error"])
    assert chosen.regressors["ridge"].damping == best["damping"]
    assert mean_error(x, chosen.regressors["ridge"].predict(z)) == best["validation_error"]


def test_rvm_is_the_sparsest_within_the_slack(chosen):
    tried = [row for row in chosen.rows if row["method"] == "rvm"]
    bound = 1.1 * min(row["validation_error"] for row in tried)
    good = [row["kept"] for row in tried if row["validation_error"] <= bound]
    assert len(tried) == 3
    assert chosen.regressors["rvm"].kept_ == min(good)


def test_rvm_n_keeps_at_most_n_percent(chosen):
    assert chosen.regressors["rvm_10"].kept_ == 0.10


def test_only_and_all_methods_asked_for(candidates, smooth):
    train, validation = smooth
    only = candidates.choose(["rvm_50", "rvm_20"], [train], [validation], mean_error)
    assert list(only.regressors) == ["rvm_50", "rvm_20"]
    assert only.regressors["rvm_20"].kept_ <= 0.2 < only.regressors["rvm_50"].kept_ <= 0.5


def test_wrong_names_and_numbers_are_refused_at_once():
    for wrong in ("svn", "rvm_", "rvm_0", "rvm_101", "ridge_3"):
        with pytest.raises(InputError, match=f"no method '{wrong}'"):
            check_methods(["ridge", wrong])
    for settings in (BasisSettings, RidgeSettings, RvmSettings):
        name = {BasisSettings: "width", RidgeSettings: "damping", RvmSettings: "nu"}[settings]
        for value in ([], [1, -1], "many"):
            with pytest.raises(InputError, match=f"{name} is to be positive numbers"):
                settings(**{name: value})


def test_without_validation_sequences_are_left_out_by_turns(candidates, smooth):
    (z, x), test = smooth
    parts = [(z[i : i + 40], x[i : i + 40]) for i in range(0, 200, 40)]
    chosen = candidates.choose(["ridge", "rvm"], parts, [], mean_error)
    assert len(chosen.regressors["ridge"].relevance_) == 200  # fitted to all of them in the end
    assert mean_error(test[1], chosen.regressors["ridge"].predict(test[0])) < 0.2
    with pytest.raises(InputError, match="validation sequence"):
        candidates.choose(["ridge"], parts[:1], [], mean_error)


def test_one_group_is_left_out_at_a_time(candidates, smooth, monkeypatch):
    (z, x), _ = smooth
    train = [(z[k::6], x[k::6]) for k in range(6)]
    groups = ["a", "b", "a", "c", "b", "a"]
    folds = candidates._folds(train, groups)
    assert [len(fold.z) for fold in folds] == [
        sum(len(t[0]) for t, g in zip(train, groups, strict=True) if g == own) for own in "abc"
    ]
    for fold in folds:
        assert len(fold.z) + len(fold.problem.z) == len(z)
        assert not {tuple(row) for row in fold.z} & {tuple(row) for row in fold.problem.z}
    monkeypatch.setattr("silpose.regression.selection.regressors._FOLDED", len(z) // 2)
    thinned = candidates._folds(train, groups)
    assert sum(len(fold.z) for fold in thinned) == pytest.approx(len(z) / 2, abs=6)
    with pytest.raises(InputError, match="needs a validation sequence"):
        candidates.choose(["ridge"], train, [], mean_error, groups=["a"] * 6)
