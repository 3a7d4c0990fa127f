from dataclasses import replace

import numpy as np
import pytest

from silpose.evaluation.gait.strides import Stride, without_turns

STRIDE = Stride("left", 1.0, 1.1, 1.5, 1.6, 2.0, 1.2, 0.6, 0.1, 1.2, 0.0, False, 1.0, (30, 61))


def test_shares_of_a_stride():
    assert STRIDE.seconds == pytest.approx(1.0)
    assert STRIDE.stance == pytest.approx(60.0)
    assert STRIDE.double_support == pytest.approx(20.0)


@pytest.mark.parametrize(("usual", "left_out"), [(2.0, [50, 100]), (40.0, [100]), (70.0, [])])
def test_sharper_turns_than_usual_are_left_out(usual, left_out):
    turns = [usual] * 8 + [50.0, -100.0]
    found = without_turns([replace(STRIDE, turn=turn) for turn in turns])
    assert [abs(s.turn) for s in found if s.fault == "turning round"] == left_out


def test_strides_follow_each_other(straight_report):
    for side in ("left", "right"):
        own = [s for s in straight_report.counted if s.side == side]
        assert len(own) >= 4
        ends, starts = [s.end for s in own[:-1]], [s.start for s in own[1:]]
        assert ends == pytest.approx(starts)


def test_steps_make_up_the_stride(straight_report):
    for s in straight_report.counted:
        assert s.frames[0] <= 30 * s.start and 30 * s.end <= s.frames[1]
        assert s.length / 2 == pytest.approx(s.step_length, rel=0.2)
        assert abs(s.turn) < 6
        assert -0.1 < s.step_width < 0.25


def test_doubtful_poses_do_not_count(straight, report_of):
    sure = np.ones(len(straight.angles[::4]))
    sure[100:] = 0.3
    report = report_of(straight, 4, confidence=sure)
    assert {s.fault for s in report.strides if s.start > 100 / 30} == {"poses that are doubtful"}
    assert report["cadence"].confidence > 0.9
