import numpy as np
import pytest

from silpose.motion import Circle, Spiral, Straight


def test_straight_goes_where_it_looks():
    np.testing.assert_allclose(
        Straight(90.0).position([0.0, 2.0]), [[0, 0, 0], [2, 0, 0]], atol=1e-6
    )
    np.testing.assert_allclose(Straight(0.0).position([2.0]), [[0, 0, 2]], atol=1e-6)


@pytest.mark.parametrize("left", [True, False])
def test_circle_closes(left):
    circle = Circle(2.0, 30.0, left)
    round_ = 4 * np.pi
    np.testing.assert_allclose(circle.position([round_])[0], 0, atol=1e-3)
    assert circle.direction(round_) == pytest.approx(390 if left else -330)
    assert np.linalg.norm(circle.position([round_ / 2])) == pytest.approx(4.0, abs=1e-3)


@pytest.mark.parametrize("start, end", [(3.0, 1.0), (1.0, 3.0), (2.0, 2.0)])
def test_spiral_makes_its_turns_between_its_radii(start, end):
    spiral = Spiral(start, end, turns=2.5, heading=10.0)
    assert spiral.direction(spiral.length) == pytest.approx(10 + 900)
    radius = 1 / np.deg2rad(np.diff(spiral.direction([0.0, 1e-4])) / 1e-4)
    assert radius[0] == pytest.approx(start, rel=1e-3)
    last = spiral.length
    radius = 1 / np.deg2rad(np.diff(spiral.direction([last - 1e-4, last, last + 1e-4])) / 1e-4)
    np.testing.assert_allclose(radius, end, rtol=1e-3)


def test_right_spiral_mirrors_left():
    distance = np.linspace(0, 20, 50)
    left, right = (Spiral(left=side).position(distance) for side in (True, False))
    np.testing.assert_allclose(left * [-1, 1, 1], right, atol=1e-9)
