import numpy as np
import pytest

from silpose.fitting.expected_pose import ExpectedPose

CHANGE = 0.01 * np.eye(54)


def after(*poses):
    """What is expected after constant poses, fitted one after the other."""
    expected = None
    for value in poses:
        expected = ExpectedPose.after(expected, np.full(54, value), CHANGE, CHANGE)
    return expected


def test_a_person_who_moves_is_expected_to_move_on():
    assert after(1.0).mean == pytest.approx(1.0)
    assert 1.2 < after(1.0, 1.2).mean[0] < 1.4


def test_a_turn_across_180_degrees_is_a_small_one():
    assert after(np.pi - 0.05, 0.05 - np.pi).mean == pytest.approx(np.full(54, 0.1 - np.pi))


def test_the_longer_ago_the_less_is_expected():
    expected = after(1.0, 1.2)
    later = expected.later().later()
    assert later.mean == pytest.approx(1.2)
    assert later.precision[0, 0] < expected.precision[0, 0] / 3
    # A fit after a gap says nothing of a velocity.
    assert ExpectedPose.after(later, np.full(54, 3.0), CHANGE, CHANGE).mean == pytest.approx(3.0)


def test_the_product_of_two_gaussians_lies_between_their_means():
    expected = after(3.1)
    mean, precision = expected.together_with(np.full(54, -3.1), expected.precision)
    assert np.abs(mean) == pytest.approx(np.pi)
    assert precision == pytest.approx(2 * expected.precision)
