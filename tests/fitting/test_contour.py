import cv2
import numpy as np
import pytest

from silpose.fitting.contour import contour_of


def test_normals_of_a_ring_lead_out_of_it():
    mask = np.zeros((80, 80), np.uint8)
    cv2.circle(mask, (40, 40), 25, 1, -1)
    cv2.circle(mask, (40, 40), 12, 0, -1)
    contour = contour_of(mask)
    away = contour.pixels - 40
    distance = np.linalg.norm(away, axis=1)
    radial = (contour.normals * away).sum(axis=1) / distance
    assert radial[distance > 20] == pytest.approx(1, abs=0.1)
    assert radial[distance < 20] == pytest.approx(-1, abs=0.2)


def test_the_image_border_is_no_contour():
    mask = np.zeros((40, 40), np.uint8)
    mask[10:, 15:25] = 1
    contour = contour_of(mask)
    assert contour.pixels[:, 1].min() == 10
    assert contour.pixels[:, 1].max() < 38


@pytest.mark.parametrize("mask", [np.zeros((20, 20)), np.ones((20, 20)), np.eye(20) * 0])
def test_without_a_contour_there_are_no_points(mask):
    assert len(contour_of(mask).pixels) == 0


@pytest.mark.parametrize("foreground", [True, 1, 255, 0.5])
def test_anything_but_0_is_foreground(foreground):
    mask = np.zeros((40, 40), np.asarray(foreground).dtype)
    mask[10:30, 10:30] = foreground
    assert len(contour_of(mask).pixels) > 20


def test_an_enlarged_contour_is_where_that_of_the_enlarged_mask_is():
    mask = np.zeros((40, 40), np.uint8)
    cv2.circle(mask, (20, 20), 12, 1, -1)
    away = contour_of(mask, 4.0).pixels - (4 * 20.5 - 0.5)
    assert np.linalg.norm(away, axis=1) == pytest.approx(46, abs=3)


def test_a_very_long_contour_is_thinned():
    noise = (np.random.default_rng(0).random((900, 900)) > 0.5).astype(np.uint8)
    contour = contour_of(noise)
    assert 300 < len(contour.pixels) <= 1000 and contour.pixels.flags.c_contiguous
