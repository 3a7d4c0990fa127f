import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.tracking import BeliefTracker, HypothesesSettings, Selection, TrackerSettings
from silpose.tracking.selection.stacking import shares_of, stacked_shares

WIDTHS = {"keep": 0.3, "pose_width": 0.4, "descriptor_width": 0.8}


@pytest.fixture
def selection(takes):
    return Selection(takes[:2], takes[2:], ANGLES, 15.0)


def squared(selection, **shares):
    tracker = BeliefTracker(**WIDTHS, **shares).fit(selection.train)
    off = np.concatenate([tracker.track(z).x - x for z, x in selection.validation])
    return (off[:, :2] ** 2).sum(), (off[:, 2:] ** 2).sum()


def test_no_other_shares_leave_less(selection):
    shares = stacked_shares(selection, BeliefTracker(**WIDTHS).fit)
    assert all(0 <= share <= 1 for share in shares.values())
    heading, body = squared(selection, **shares)
    for other in (0.0, 0.2, 0.5, 1.0):
        others = squared(selection, heading_alone=other, body_alone=other)
        assert heading <= others[0] + 1e-9
        assert body <= others[1] + 1e-9


class Off(BeliefTracker):
    """Tracks with this much off, and with that much off on the silhouette alone."""

    def __init__(self, tracked=1.0, alone=0.0, heading_alone=0.0, body_alone=0.0):
        self.tracked, self.alone = tracked, alone
        self.heading_alone, self.body_alone = heading_alone, body_alone

    def track(self, z):
        track = type("Track", (), {})()
        off = self.tracked + self.body_alone * (self.alone - self.tracked)
        track.x = np.full((len(z), 55), off)
        return track


@pytest.mark.parametrize(("alone", "share"), [(0.0, 1.0), (-1.0, 0.5), (2.0, 0.0), (1.0, 0.0)])
def test_a_share_is_what_evens_errors_out(selection, alone, share):
    nowhere = [(z, np.zeros_like(x)) for z, x in selection.validation]
    only = Selection(selection.train, nowhere, ANGLES, 15.0)
    found = stacked_shares(only, lambda learnt: Off(alone=alone))
    assert found == pytest.approx({"heading_alone": share, "body_alone": share})


@pytest.mark.parametrize("kind", [TrackerSettings, HypothesesSettings])
def test_shares_that_are_given_are_not_stacked(selection, kind):
    whole = kind(heading_alone=0.25, body_alone=0.75)
    given = {"heading_alone": 0.25, "body_alone": 0.75}
    assert shares_of("tracker", whole, selection, None) == given
    assert selection.rows == []
    half = shares_of("tracker", kind(body_alone=0.75), selection, BeliefTracker(**WIDTHS).fit)
    stacked = stacked_shares(selection, BeliefTracker(**WIDTHS).fit)
    assert half == stacked | {"body_alone": 0.75}
    assert selection.rows == [{"method": "tracker", **half}]
