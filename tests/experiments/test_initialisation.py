import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.experiments.initialisation import LOCKED_SHARE, shares_within


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
    x = ANGLES.from_angles(np.zeros((30, 54)))

    def late():
        """Headings that are off until ten frames after each start."""
        for start in range(len(x)):
            off = np.zeros((len(x) - start, 54))
            off[:10, 0] = 90
            yield ANGLES.from_angles(off)

    assert np.all(shares_within(ANGLES, x, late(), late(), 10)[[0, 14, 29]] == 1)
    shares = shares_within(ANGLES, x, late(), late(), 5)
    assert shares[0] == shares[29] == pytest.approx(20 / 25)
    assert shares[14] == pytest.approx((6 + 5) / (11 + 10))
    short = [x[:3], x[:2], x[:1]]
    assert np.isnan(shares_within(ANGLES, x[:3], short, short, 5)).all()
