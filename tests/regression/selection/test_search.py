import joblib
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from silpose.regression import Fold, Outcome, best, search
from silpose.regression.selection import settings_of

SETTINGS = [{"a": a, "b": b} for a in (1, 2) for b in (10, 20, 30)]
FRAMES = st.integers(1, 9)
ERRORS = st.lists(st.tuples(st.floats(1e-3, 1e3), FRAMES), min_size=2, max_size=5)
LOGS = st.lists(st.tuples(st.floats(-1e3, 1e3), FRAMES), min_size=2, max_size=5)


def fold_of(frames, number=0):
    x = np.full((frames, 1), float(number))
    return Fold([(x, x)], [(x, x)])


def average(folds, score="validation_error"):
    """Average of the scores of some folds, each given with its frames."""
    scores = [value for value, _ in folds]

    def scorer(fold, settings):
        return [Outcome.of(scores[int(fold.x[0, 0])]) for _ in settings]

    pairs = [fold_of(frames, k) for k, (_, frames) in enumerate(folds)]
    return search(scorer, pairs, [{"a": 1}], score=score)[0][score]


def sums(fold, settings):
    return [Outcome.of(s["a"] * s["b"] + fold.frames, kept=s["a"] / fold.frames) for s in settings]


@given(ERRORS)
def test_errors_are_averaged_geometrically_by_frames(folds):
    logs = [np.log(error) for error, frames in folds for _ in range(frames)]
    assert average(folds) == pytest.approx(np.exp(np.mean(logs)))


@given(LOGS)
def test_log_likelihoods_are_averaged_arithmetically_by_frames(folds):
    values = [value for value, frames in folds for _ in range(frames)]
    found = average(folds, "validation_log_likelihood")
    assert found == pytest.approx(np.mean(values), abs=1e-9)


@given(ERRORS, st.floats(1e-3, 1e3))
def test_a_fold_that_fails_with_any_setting_does_not_decide(folds, factor):
    def ratio(scale):  # of two settings, the second 10 % worse on the last fold
        *others, (error, frames) = folds
        one, other = ([*others, (e * scale, frames)] for e in (error, 1.1 * error))
        return average(other) / average(one)

    assert ratio(factor) == pytest.approx(ratio(1.0))


@given(st.floats(1e-9, 1e9))
def test_the_score_of_a_single_fold_is_kept_to_the_last_digit(score):
    assert average([(score, 7)]) == score


def test_an_error_of_zero_is_the_best():
    assert 0 < average([(0.0, 2), (5.0, 2)]) < average([(1e-3, 2), (5.0, 2)])


def test_rows_are_in_the_order_of_the_settings_and_complete():
    rows = search(sums, [fold_of(2), fold_of(4)], SETTINGS, method="sum", fitted_once=("b",))
    assert [list(row) for row in rows] == [["method", "a", "b", "kept", "validation_error"]] * 6
    assert [settings_of(row, ("a", "b")) for row in rows] == SETTINGS
    assert {row["method"] for row in rows} == {"sum"}
    assert rows[0]["kept"] == pytest.approx((1 / 2 + 1 / 4) / 2)  # a plain mean over the folds


@pytest.mark.parametrize(("once", "batches"), [((), 1), (("a",), 2), (("b",), 3), (("a", "b"), 6)])
def test_settings_that_share_what_is_fitted_are_scored_together(once, batches):
    calls = []

    def scorer(fold, settings):
        calls.append(settings)
        return [Outcome.of(1) for _ in settings]

    search(scorer, [fold_of(1), fold_of(1)], SETTINGS, fitted_once=once)
    assert len(calls) == 2 * batches
    for settings in calls:
        assert all(len({setting[name] for setting in settings}) == 1 for name in once)


@pytest.mark.parametrize("prefer", ["threads", "processes"])
def test_side_by_side_it_finds_the_same(prefer):
    pairs = [fold_of(2), fold_of(5)]
    alone = search(sums, pairs, SETTINGS, fitted_once=("a",))
    with joblib.parallel_config(n_jobs=2):
        assert search(sums, pairs, SETTINGS, fitted_once=("a",), prefer=prefer) == alone


@pytest.mark.parametrize(
    ("score", "expected"),
    [("validation_error", 1), ("validation_log_likelihood", 3), ("validation_brier_score", 1)],
)
def test_the_best_is_the_smallest_error_or_the_largest_likelihood(score, expected):
    rows = [{"a": k, score: value} for k, value in enumerate((3.0, 1.0, 1.0, 5.0))]
    assert best(rows, score)["a"] == expected  # of several the first
