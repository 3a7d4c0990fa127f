import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.experiments.initialisation import LOCKED_SHARE, share_within


@pytest.fixture(scope="module")
def initialisation(run, walkers):
    return run("initialisation", walkers)


def test_every_frame_is_a_start(initialisation):
    bars = [axes.patches for axes in initialisation.result.figure.axes]
    assert [len(own) for own in bars] == 3 * [45]
    for own, (method, values) in zip(bars, initialisation.metrics.items(), strict=True):
        shares = np.array([bar.get_height() for bar in own])
        assert values["within_20deg"] == pytest.approx(shares.mean()), method
        assert values["locked_on"] == pytest.approx((shares >= LOCKED_SHARE).mean())


def test_waiting_for_later_frames_does_not_lose_the_track(initialisation):
    within = initialisation.values("within_20deg")
    assert within["tracker_lag"] >= within["tracker"] - 0.05
    assert within["tracker"] > 0.5


def test_frames_count_after_settling_and_in_both_directions():
    angles = np.zeros((30, 54))
    x = ANGLES.from_angles(angles)

    def late(z, back):
        """Headings off until ten frames after the start."""
        off = np.zeros((len(z), 54))
        first = np.arange(len(z))[::-1] if back else np.arange(len(z))
        off[first < 10, 0] = 90
        return ANGLES.from_angles(off)

    assert share_within(ANGLES, x, x, 0, 10, late) == 1
    assert share_within(ANGLES, x, x, 0, 5, late) == pytest.approx(20 / 25)
    assert share_within(ANGLES, x, x, 29, 5, late) == pytest.approx(20 / 25)
    assert share_within(ANGLES, x, x, 14, 5, late) == pytest.approx((6 + 5) / (11 + 10))
    assert np.isnan(share_within(ANGLES, x[:3], x[:3], 1, 5, late))
