import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from video_films import noisy, wall, write_film

from silpose.silhouette.video import VideoMasks
from silpose.silhouette.video.whole_clip import even_times


@given(st.lists(st.floats(0.005, 0.3), min_size=1, max_size=40))
def test_ticks_take_the_nearest_frame(intervals):
    time = np.concatenate([[0], np.cumsum(intervals)])
    order, rate = even_times(time, None)
    assert (np.diff(order) >= 0).all()
    assert order[0] == 0
    assert set(order.tolist()) <= set(range(len(time)))
    if len(order) != len(time):
        off = np.abs(time[order] - np.arange(len(order)) / rate)
        best = np.abs(time[None] - np.arange(len(order))[:, None] / rate).min(axis=1)
        assert off == pytest.approx(best, abs=1e-9)


def test_even_times_are_left_alone_and_a_gap_is_filled():
    order, rate = even_times(np.arange(10) / 25 + 0.004 * (np.arange(10) % 2), 25)
    assert order.tolist() == list(range(10))
    assert rate == 25
    order, rate = even_times(np.array([0, 1, 2, 6, 7]) / 25, 25)
    assert order.tolist() == [0, 1, 2, 2, 3, 3, 3, 4] or len(order) == 8
    assert even_times(np.array([0.0]), None)[1] is None
    assert even_times(np.arange(9) / 60, 30)[1] == pytest.approx(60)  # a rate that is wrong


def test_a_clip_without_a_person_is_said(tmp_path):
    rng = np.random.default_rng(0)
    film = write_film(tmp_path / "empty.mp4", [noisy(wall(), rng) for _ in range(6)])
    with pytest.warns(UserWarning, match="nobody is told from the background"):
        sequence = VideoMasks(film).masks()
    assert not any(mask.any() for mask in sequence)
