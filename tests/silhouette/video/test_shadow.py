import numpy as np
from video_films import noisy, paint, wall

from silpose.silhouette.video.shadow import shadow

EVERYWHERE = np.ones((144, 192), np.uint8)


def test_a_shadow_is_told_from_a_person_by_brightness_and_colour(truth):
    rng, scene = np.random.default_rng(0), wall()
    person, cast = truth[5], np.roll(truth[5], 50, axis=1)
    shaded = np.where(cast[..., None] > 0, 0.75 * scene, scene)
    picture = noisy(paint(shaded, person), rng)
    found = shadow(picture, scene.astype(np.uint8), person | cast, 0.6, 0.04)
    assert found[cast > 0].mean() > 0.85
    assert found[person > 0].mean() < 0.1


def test_what_is_brighter_or_much_darker_or_outside_the_mask_is_no_shadow():
    scene = wall().clip(0, 200)
    for factor in (0.4, 1.2):
        found = shadow(
            (factor * scene).astype(np.uint8), scene.astype(np.uint8), EVERYWHERE, 0.6, 0.04
        )
        assert found.mean() < 0.01
    nothing = np.zeros_like(EVERYWHERE)
    assert not shadow(scene.astype(np.uint8), scene.astype(np.uint8), nothing, 0.6, 0.04).any()
