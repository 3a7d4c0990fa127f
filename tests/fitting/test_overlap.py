import numpy as np
import pytest

from silpose.core.pose_space import ANGLES as SPACE
from silpose.fitting.contour import contour_of
from silpose.fitting.geometry import geometry_of
from silpose.fitting.overlap import aligned, outline_error, overlap, silhouette_of
from silpose.fitting.parameters import LOG_SCALE, PARAMETERS, SHIFT_X, SHIFT_Y


@pytest.fixture
def true(walk):
    """Parameters of a frame of the walk."""
    parameters = np.zeros(PARAMETERS)
    parameters[:54] = np.deg2rad(SPACE.angles(walk[0][0]))
    return parameters


def test_overlap_is_intersection_over_union():
    one, other = np.zeros((4, 4), np.uint8), np.zeros((4, 4), np.uint8)
    assert overlap(one, other) == 0
    one[:2], other[1:3] = 1, 255
    assert overlap(one, other) == pytest.approx(1 / 3)


def test_the_true_body_covers_its_mask(body, camera, view, walk, true):
    of = np.zeros(3), geometry_of(body), view, camera.height, camera.width
    assert overlap(silhouette_of(true, *of), walk[1][0]) > 0.98


def test_a_body_out_of_place_is_brought_to_the_contour(body, view, walk, true):
    moved = true.copy()
    moved[[SHIFT_X, SHIFT_Y, LOG_SCALE]] = 20.0, -10.0, 0.3
    of = np.zeros(3), contour_of(walk[1][0]), geometry_of(body), view
    np.testing.assert_allclose(aligned(moved, *of)[54:56], 0, atol=2.0)
    assert aligned(moved, *of)[LOG_SCALE] == pytest.approx(0, abs=0.02)


def test_an_outline_one_pixel_off_is_so_by_its_overlap():
    mask = np.zeros((100, 100), np.uint8)
    mask[20:80, 20:80] = 1
    smaller = np.zeros_like(mask)
    smaller[21:79, 21:79] = 1
    error = outline_error(overlap(smaller, mask), mask, contour_of(mask), 1.0)
    assert error == pytest.approx(1, abs=0.1)
