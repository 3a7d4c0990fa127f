import numpy as np
import pytest
from video_films import noisy, overlap, paint, wall

from silpose.silhouette.video.backgrounds import AdaptiveBackground, FixedBackground, Shadows

SHADOWS = Shadows(0.6, 0.04)


@pytest.mark.parametrize("sigma", [0, 2, 6])
def test_a_person_differs_and_noise_does_not(truth, sigma):
    rng = np.random.default_rng(0)
    background = FixedBackground(wall().astype(np.uint8), 20, SHADOWS)
    found = background.step(noisy(paint(wall(), truth[9]), rng, sigma))
    assert overlap(found.weak, truth[9]) > 0.95
    assert (found.strong <= found.weak).all()
    assert not found.switched


@pytest.mark.parametrize("sigma", [15, 25])
def test_strong_noise_hides_nobody(truth, sigma):
    rng = np.random.default_rng(0)
    still = np.full((144, 192), round(sigma / 1.5), np.uint8)
    background = FixedBackground(wall().astype(np.uint8), 20, SHADOWS, still)
    found = background.step(noisy(paint(wall(), truth[9]), rng, sigma))
    assert overlap(found.weak, truth[9]) > 0.85
    assert overlap(found.strong, truth[9]) > 0.4
    assert not background.step(noisy(wall(), rng, sigma)).strong.any()


def test_a_pixel_that_flickers_needs_more(truth):
    noise = np.zeros((144, 192), np.uint8)
    noise[:, :40] = 12
    background = FixedBackground(np.full((144, 192, 3), 120, np.uint8), 20, None, noise)
    found = background.step(np.full((144, 192, 3), 120, np.uint8) + np.uint8(0))
    assert not found.weak.any()
    picture = np.full((144, 192, 3), 120, np.uint8)
    picture[20:40] = 160
    assert not background.step(picture).weak[:, :40].any()
    assert background.step(picture).weak[20:40, 40:].all()


@pytest.mark.parametrize("kind", ["mog2", "knn"])
def test_opencvs_backgrounds_learn_beforehand_and_survive_a_light(truth, pictures, kind):
    rng = np.random.default_rng(0)
    background = AdaptiveBackground(kind, 20, SHADOWS, 200, pictures)
    assert overlap(background.step(pictures[10]).weak, truth[10]) > 0.85
    darker = [noisy(0.7 * paint(wall(), truth[k]), rng) for k in (11, 12)]
    assert background.step(darker[0]).switched
    found = background.step(darker[1])
    assert not found.switched
    assert overlap(found.weak, truth[12]) > 0.75
