"""Real films: of a person who walks by a white wall, and of one who balances."""

from pathlib import Path

import numpy as np
import pytest

from silpose.silhouette.video import VideoMasks

FILMS = Path(__file__).parents[4] / "shared" / "video"

pytestmark = [
    pytest.mark.shared,
    pytest.mark.skipif(not FILMS.is_dir(), reason="the films are not on this machine"),
]


def test_a_walker_is_seen_whole_in_every_frame():
    video = VideoMasks(FILMS / "walkgait" / "walk.mp4", first=30, last=90)
    frames = list(video)
    assert {frame.state for frame in frames} == {"person"}
    heights = np.array([frame.facts.height[0] for frame in frames])
    assert np.abs(heights / 244 - 1).max() < 0.06
    areas = np.array([float(frame.mask.sum()) for frame in frames])
    assert np.median(np.abs(np.diff(np.log(areas)))) < 0.03
    assert video.frames_per_second == pytest.approx(29.76, abs=0.01)


def test_one_who_stays_is_told_from_a_picture_of_the_empty_scene():
    folder = FILMS / "balance"
    frames = list(
        VideoMasks(
            folder / "cam04.mp4", str(folder / "cam04_background.png"), longest_side=640, last=30
        )
    )
    assert {frame.state for frame in frames} == {"person"}
    areas = np.array([float(frame.mask.sum()) for frame in frames])
    assert np.median(np.abs(np.diff(np.log(areas)))) < 0.02
