import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.regression import Candidates, MixtureOfRegressors, choose_mixture
from silpose.tracking import (
    MultipleHypothesisTracker,
    SecondOrderDynamics,
    TrackerSelection,
    choose_hypothesis_tracker,
)

GRID = {"likelihood_exponent": [0.05, 0.1], "velocity_gain": [0.5, 0.7]}


@pytest.fixture(scope="module")
def parts(takes):
    """A mixture chosen by turns, and dynamics."""
    mixture = Candidates(MixtureOfRegressors(20, dimensions=30))
    chosen = choose_mixture(mixture, takes, [], units=ANGLES.units, distance=ANGLES.distance)
    return chosen, SecondOrderDynamics().fit([x for _, x in takes])


def candidates(grid=GRID, **parameters):
    return Candidates(MultipleHypothesisTracker(keep=0.3, **parameters), grid)


@pytest.fixture
def turns(takes):
    return TrackerSelection(takes, [], ANGLES, 15.0)


def test_the_setting_best_on_validation_wins_then_shares_are_stacked(turns, parts, unseen):
    tracker = choose_hypothesis_tracker(turns, candidates(), *parts)
    *searched, shares = turns.rows
    best = min(searched, key=lambda row: row["validation_error"])
    assert len(searched) == 4
    assert [getattr(tracker, name) for name in GRID] == [best[name] for name in GRID]
    assert tracker.heading_alone == shares["heading_alone"]
    assert turns.validation_error("hypotheses") == shares["validation_error"]
    assert tracker.track(unseen[0]).x.shape == unseen[1].shape


def test_fitted_parts_are_used_and_no_mixture_is_fitted_again(turns, parts, monkeypatch):
    monkeypatch.setattr(MixtureOfRegressors, "fit_with", None)
    tracker = choose_hypothesis_tracker(turns, candidates(), *parts)
    assert tracker.mixture_ is parts[0].mixture
    assert tracker.dynamics_ is parts[1]


def test_a_single_setting_is_not_searched(turns, parts):
    given = candidates({}, heading_alone=0.0, body_alone=0.1)
    choose_hypothesis_tracker(turns, given, *parts)
    assert turns.rows == []
    assert np.isfinite(turns.validation_error("hypotheses"))
    assert turns.rows[0]["body_alone"] == 0.1


def test_what_is_not_searched_is_refused(turns, parts):
    with pytest.raises(InputError, match=r"tracking\.hypotheses\.keep is not chosen"):
        choose_hypothesis_tracker(turns, candidates({"keep": [0.1, 0.2]}), *parts)
