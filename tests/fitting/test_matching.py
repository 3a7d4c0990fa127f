import numpy as np
import pytest

from silpose.fitting.contour import Contour
from silpose.fitting.matching import Matching, compare
from silpose.fitting.outline import Outline


def outline_of(pixels, normals):
    count = len(pixels)
    where = np.zeros(count, np.int64)
    return Outline(pixels, normals, where, where, where, np.zeros(count), np.zeros((count, 3)))


@pytest.fixture
def circle():
    """Points (40, 2) of a circle, and its normals."""
    angles = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    normals = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return 50 + 20 * normals, normals


def test_a_contour_matches_itself(circle):
    pairs = compare(outline_of(*circle), Contour(*circle), Matching())
    np.testing.assert_array_equal(pairs.outline, pairs.contour)
    np.testing.assert_allclose(pairs.residuals, 0, atol=1e-9)
    assert pairs.misfit == pytest.approx(0)
    assert pairs.weights.sum() == pytest.approx(2 * Matching().independent_points)


def test_residuals_are_along_the_observed_normals(circle):
    pixels, normals = circle
    pairs = compare(outline_of(pixels, normals), Contour(pixels + normals, normals), Matching())
    np.testing.assert_allclose(pairs.residuals, 1)


def test_partners_face_the_same_way():
    """Of a thin limb's two sides the nearer one may be the wrong one."""
    pixels, normals = np.array([[0.0, 0.0]]), np.array([[1.0, 0.0]])
    sides = Contour(np.array([[1.0, 0.0], [4.0, 0.0]]), np.array([[-1.0, 0.0], [1.0, 0.0]]))
    pairs = compare(outline_of(pixels, normals), sides, Matching())
    assert pairs.contour[0] == 1
    blind = compare(outline_of(pixels, normals), sides, Matching(normal_weight=0.0))
    assert blind.contour[0] == 0


def test_clothes_outside_the_body_weigh_less_than_a_body_outside_the_mask(circle):
    pixels, normals = circle
    body, clothed = outline_of(pixels, normals), Matching().clothed()
    wide = compare(body, Contour(pixels + normals, normals), clothed)
    tight = compare(body, Contour(pixels - normals, normals), clothed)
    assert wide.weights.sum() == pytest.approx(clothed.outside * tight.weights.sum())
    assert clothed.independent_points < Matching().independent_points
