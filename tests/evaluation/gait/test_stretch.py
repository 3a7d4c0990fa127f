import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.evaluation.gait import Walk
from silpose.evaluation.gait.stretch import RATE, stretches


def test_poses_are_cut_at_long_gaps_only(straight, make_walk):
    walk = make_walk(straight, 4)
    x = ANGLES.from_angles(straight.angles[::4])
    x[50:53] = np.nan
    x[120:150] = np.nan
    first, last = stretches(Walk.from_poses(x, frames_per_second=30.0))
    assert first.time[[0, -1]] == pytest.approx([0.0, 119 / 30], abs=1 / RATE)
    assert last.time[0] == pytest.approx(5.0)
    whole = stretches(walk)[0]
    near = np.abs(whole.lead("left_heel")[100:300] - first.lead("left_heel")[100:300])
    assert near.max() < 0.05


def test_the_heading_is_without_the_twist_of_the_pelvis(straight, make_walk):
    (stretch,) = stretches(make_walk(straight, 4))
    assert np.abs(stretch.heading[100:-100] - 30.0).max() < 4.0
    assert stretch.pace[100:-100].min() > 0.5


def test_the_foot_that_stands_gives_the_path(straight, make_walk):
    (given,), (found,) = (stretches(make_walk(straight, 4, **o)) for o in ({}, {"path": None}))
    ways = [np.linalg.norm((s.path[-1] - s.path[0])[[0, 2]]) for s in (given, found)]
    assert ways[1] == pytest.approx(ways[0], rel=0.05)
    angle = [np.arctan2(*(s.path[-1] - s.path[0])[[0, 2]]) for s in (given, found)]
    assert np.rad2deg(angle[1]) == pytest.approx(np.rad2deg(angle[0]), abs=3.0)


def test_what_is_too_short_is_no_stretch(straight, make_walk):
    for seconds in (0.0, 0.1, 0.9):
        part = straight.part(0, int(120 * seconds))
        assert stretches(make_walk(part)) == []
