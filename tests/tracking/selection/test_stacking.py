import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.tracking import BeliefTracker
from silpose.tracking.selection.stacking import _tracked, choose_shares, stacked_shares
from silpose.tracking.selection.tracker_selection import FittedFold

WIDTHS = {"keep": 0.3, "pose_width": 0.4, "descriptor_width": 0.8}


def fitted(fold):
    return BeliefTracker(**WIDTHS).fit(fold.train)


def folds(selection):
    return [FittedFold(fold.train, fold.validation, None) for fold in selection.folds]


def shares_of(selection, **given):
    return choose_shares(
        selection, "tracker", BeliefTracker(**given), {"damping": 1.0}, fitted,
        lambda: folds(selection),
    )  # fmt: skip


def squared(selection, **shares):
    tracker = BeliefTracker(**WIDTHS, **shares).fit(selection.train)
    off = np.concatenate([tracker.track(z).x - x for z, x in selection.validation])
    return (off[:, :2] ** 2).sum(), (off[:, 2:] ** 2).sum()


def test_no_other_shares_leave_less(selection):
    shares = stacked_shares(_tracked(fitted, folds(selection)))
    assert all(0 <= share <= 1 for share in shares.values())
    heading, body = squared(selection, **shares)
    for other in (0.0, 0.2, 0.5, 1.0):
        others = squared(selection, heading_alone=other, body_alone=other)
        assert heading <= others[0] + 1e-9
        assert body <= others[1] + 1e-9


@pytest.mark.parametrize(("alone", "share"), [(0.0, 1.0), (-1.0, 0.5), (2.0, 0.0), (1.0, 0.0)])
def test_a_share_is_what_evens_errors_out(selection, alone, share):
    """The tracker is 1 off everywhere, and this much off on the silhouette alone."""
    ((z, x),) = selection.validation
    parts = np.ones_like(x), np.full_like(x, alone - 1)
    only = FittedFold([], [(z, np.zeros_like(x))], parts)
    found = stacked_shares([only])
    assert found == pytest.approx({"heading_alone": share, "body_alone": share})


def test_shares_are_recorded_with_the_error_that_they_leave(selection):
    shares = shares_of(selection)
    (row,) = selection.rows
    assert {"method": "tracker", "damping": 1.0, **shares}.items() <= row.items()
    tracker = BeliefTracker(**WIDTHS, **shares).fit(selection.train)
    (z, x), *_ = selection.validation
    error = ANGLES.distance(x, tracker.track(z).x).mean()
    assert row["validation_error"] == pytest.approx(error)
    assert selection.validation_error("tracker") == row["validation_error"]


def test_shares_that_are_given_are_not_stacked(selection):
    given = {"heading_alone": 0.25, "body_alone": 0.75}
    assert shares_of(selection, **given) == given
    assert selection.rows == []
    half = shares_of(selection, body_alone=0.75)
    assert half == shares_of(selection) | {"body_alone": 0.75}


def test_the_error_of_shares_that_are_given_is_computed_when_asked_for(selection):
    given = {"heading_alone": 0.25, "body_alone": 0.75}
    shares_of(selection, **given)
    tracker = BeliefTracker(**WIDTHS, **given).fit(selection.train)
    (z, x), *_ = selection.validation
    error = ANGLES.distance(x, tracker.track(z).x).mean()
    assert selection.validation_error("tracker") == pytest.approx(error)
    assert selection.rows[0]["heading_alone"] == 0.25
