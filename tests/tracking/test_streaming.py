"""What all trackers promise of `step`."""

import numpy as np
import pytest

from silpose.regression import MixtureOfRegressors
from silpose.tracking import BeliefTracker, MultipleHypothesisTracker


@pytest.mark.parametrize(
    "tracker",
    [
        BeliefTracker(keep=0.3, pose_width=0.4, descriptor_width=0.8),
        MultipleHypothesisTracker(MixtureOfRegressors(20, 30, hellinger=True)),
    ],
    ids=lambda tracker: type(tracker).__name__,
)
def test_frame_by_frame_is_the_same_as_in_one_go(tracker, takes, unseen):
    z = unseen[0].copy()
    z[40:44] = np.nan
    track = tracker.fit(takes).track(z)
    tracker.start()
    steps = [tracker.step(row) for row in z]
    assert np.array([x for x, _ in steps]) == pytest.approx(track.x)
    assert [state for _, state in steps] == track.state
