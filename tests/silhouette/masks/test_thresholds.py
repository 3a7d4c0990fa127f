import cv2
import numpy as np
import pytest

from silpose.silhouette.masks.levels import Levels
from silpose.silhouette.masks.thresholds import (
    Threshold,
    bright_border,
    is_shadow,
    like_masks,
    shadow_of,
    shows_nothing,
    solid_levels,
    surrounds,
    two_levels,
)


@pytest.fixture
def soft(figures):
    large = [cv2.resize(255 * mask, None, fx=4, fy=4) for mask in figures]
    return [cv2.GaussianBlur(picture, (0, 0), 2) for picture in large]


def test_inverted_is_the_rest(figures):
    np.testing.assert_array_equal(Threshold(0.5).apply(figures[0]), figures[0])
    np.testing.assert_array_equal(Threshold(0.5, inverted=True).apply(figures[0]), 1 - figures[0])


def test_values_on_edges_are_no_levels(figures):
    small = [cv2.resize(255 * mask, (20, 24), interpolation=cv2.INTER_AREA) for mask in figures]
    np.testing.assert_array_equal(solid_levels(Levels.of(small)), [0, 255])
    stripes = figures[0].copy()
    stripes[20:] *= 2
    np.testing.assert_array_equal(solid_levels(Levels.of([stripes])), [0, 1, 2])


def test_shadows_of_background_subtraction_are_known(soft):
    assert is_shadow(np.array([0, 127, 255]))
    assert not is_shadow(np.array([0, 80, 160])) and not is_shadow(np.array([0, 1, 2]))
    assert shadow_of(Levels.of(soft)) is None
    for picture in soft:
        picture[170:185, 30:90] = 126
    assert shadow_of(Levels.of(soft)) == pytest.approx(126, abs=1)


def test_a_band_that_always_parts_person_and_background_surrounds(figures):
    wide = cv2.dilate(figures[0], np.ones((5, 5), np.uint8))
    levels = np.array([0, 128, 255])
    assert surrounds([np.where(figures[0], 255, 128 * wide).astype(np.uint8)], levels)
    shadow = np.where(figures[0], 255, 128 * np.roll(figures[0], 6, axis=1)).astype(np.uint8)
    assert not surrounds([shadow], levels)


def test_photos_are_not_like_masks(soft, photo):
    assert like_masks(Levels.of(soft), None).all()
    assert not like_masks(Levels.of([photo[..., k] for k in range(3)]), None).any()
    person = [np.where(m > 127, cv2.resize(photo[..., 0], m.shape[::-1]), 0) for m in soft]
    assert not like_masks(Levels.of(person), None).any()  # cut out, with all its shades


def test_black_noise_shows_nothing():
    noise = np.random.default_rng(0).integers(0, 5, (20, 20), dtype=np.uint8)
    assert shows_nothing(Levels.of([noise]))
    assert not shows_nothing(Levels.of([10 * noise]))


def test_borders_and_usual_levels(figures):
    levels = Levels.of([100 + 50 * mask for mask in figures])
    assert two_levels(levels) == (100, 150)
    assert bright_border(levels, 125) == 0 and bright_border(levels, 50) == 1
