import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from silpose.silhouette.video.clock import Clock


@given(st.lists(st.none() | st.floats(-1e7, 1e7), min_size=1, max_size=30))
def test_times_increase_from_0_whatever_the_stamps_are(stamps):
    clock = Clock(25)
    times = [clock.step(stamp) for stamp in stamps]
    assert times[0] == 0
    assert all(np.diff(times) > 0)
    assert np.isfinite(times).all()


def test_a_clock_that_leaps_goes_on_by_its_own_differences():
    clock = Clock(10)
    times = [clock.step(stamp) for stamp in (100.0, 100.1, 100.3, 5.0, 5.2)]
    assert times == pytest.approx([0, 0.1, 0.3, 0.4, 0.6])
