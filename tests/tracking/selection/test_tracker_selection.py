import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.tracking import GIVEN, TrackerSelection
from silpose.tracking.selection.tracker_selection import FittedFold, outcomes

CHOICES = [{"choice": 0}, {"choice": 1}]


def scorer(calls=None):
    """Of choice 1 every pose is 1 off in all 54 angles, of choice 0 it is 2 off."""

    def score(fold, settings):
        if calls is not None:
            calls.append(settings)
        made = (lambda z, start, s=s: np.full((len(z), 55), 2.0 - s["choice"]) for s in settings)
        return outcomes(ANGLES, fold, made)

    return score


@pytest.fixture
def flat(takes):
    return [(z, np.zeros_like(x)) for z, x in takes]


def test_the_setting_of_least_error_is_chosen(flat):
    selection = TrackerSelection(flat[:2], flat[2:], ANGLES, 15.0)
    assert selection.choose("any", CHOICES, scorer(), lambda: selection.folds) == {"choice": 1}
    errors = [row["validation_error"] for row in selection.rows]
    assert [row["method"] for row in selection.rows] == ["any", "any"]
    assert errors[0] > errors[1]
    assert selection.validation_error("any") == errors[1]
    assert selection.validation_error("other") is None


def test_a_single_setting_is_scored_only_when_its_error_is_asked_for(flat):
    selection = TrackerSelection(flat[:2], flat[2:], ANGLES, 15.0)
    calls, fitted = [], []

    def folds():
        fitted.append(True)
        return selection.folds

    assert selection.choose("any", CHOICES[:1], scorer(calls), folds) == {"choice": 0}
    assert calls == fitted == selection.rows == []
    error = selection.validation_error("any")
    assert selection.rows == [{"method": "any", "choice": 0, "validation_error": error}]
    assert selection.validation_error("any") == error
    assert len(calls) == len(fitted) == 1


def test_a_hopeless_take_does_not_decide(flat):
    def score(fold, settings):
        # 2 % better on the take that fails anyhow, 20 % worse on the others.
        hopeless = fold.train[0] is not flat[0]
        errors = {True: (50.0, 49.0), False: (1.0, 1.2)}[hopeless]
        made = (lambda z, start, s=s: np.full((len(z), 55), errors[s["choice"]]) for s in settings)
        return outcomes(ANGLES, fold, made)

    selection = TrackerSelection(flat, [], ANGLES, 15.0)
    assert selection.choose("any", CHOICES, score, lambda: selection.folds) == {"choice": 0}


def test_without_validation_takes_each_is_held_out_once(takes):
    selection = TrackerSelection(takes, [], ANGLES, 15.0)
    held_out = [id(take[0]) for fold in selection.folds for take in fold.validation]
    assert sorted(held_out) == sorted(id(z) for z, _ in takes)
    assert all(len(fold.train) == 2 for fold in selection.folds)


def test_of_many_takes_every_few_judge():
    takes = [(np.full((50, 1), k), np.zeros((50, 55))) for k in range(80)]
    (fold,) = TrackerSelection(takes[:40], takes[40:], ANGLES, 15.0).folds
    assert [z[0, 0] for z, _ in fold.validation] == list(range(40, 80, 3))
    assert len(fold.train) == 40


def test_estimates_are_given_the_first_poses_only(flat):
    selection = TrackerSelection(flat[:2], flat[2:], ANGLES, 15.0)
    starts = []

    def estimate(z, start):
        starts.append(start)
        return np.zeros((len(z), 55))

    (outcome,) = outcomes(ANGLES, selection.folds[0], [estimate])
    assert [start.shape for start in starts] == [(GIVEN, 55)]
    assert outcome.score == 0


def test_what_settings_share_is_fitted_once_to_every_fold(takes):
    selection = TrackerSelection(takes, [], ANGLES, 15.0)
    fitted = selection.fitted_folds(lambda fold: len(fold.train))
    assert all(isinstance(fold, FittedFold) and fold.fitted == 2 for fold in fitted)
    assert [fold.frames for fold in fitted] == [fold.frames for fold in selection.folds]
