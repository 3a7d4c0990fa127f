import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial import ConvexHull

from silpose.fitting.convex_hull import convex_hull


def corners_of(points):
    count = len(points)
    hull, order = np.empty(2 * count, np.int64), np.empty(count, np.int64)
    return hull[: convex_hull(points, hull, order)]


@pytest.mark.parametrize("count", [3, 8, 64])
def test_corners_are_those_of_qhull_in_order(count):
    for seed in range(50):
        points = np.random.default_rng(seed).normal(size=(count, 2))
        found = corners_of(points)
        assert set(found) == set(ConvexHull(points).vertices)
        x, y = points[np.append(found, found[0])].T
        assert (x[:-1] * y[1:] - x[1:] * y[:-1]).sum() > 0  # around in one direction


@given(arrays(np.int8, st.tuples(st.integers(1, 20), st.just(2)), elements=st.integers(-3, 3)))
def test_points_that_coincide_or_lie_on_a_line(points):
    points = points.astype(float)
    found = points[corners_of(points)]
    if len(np.unique(points, axis=0)) == 1:
        assert len(found) == 1
    assert len(np.unique(found, axis=0)) == len(found)  # no corner twice
    sides = np.roll(found, -1, axis=0) - found
    for corner, side in zip(found, sides, strict=True):
        off = points - corner
        assert (side[0] * off[:, 1] - side[1] * off[:, 0] >= 0).all()  # none is outside
