import numpy as np
import pytest
from video_films import noisy, paint, wall

from silpose.silhouette.video.light import Light, lit


@pytest.mark.parametrize("factor", [0.6, 0.85, 1.15])
def test_a_gain_is_found_beside_a_person_and_a_switch_is_told(truth, factor):
    scene, rng = wall().clip(0, 200), np.random.default_rng(0)
    light = Light(scene.astype(np.uint8))
    person = paint(scene, truth[12])
    gain, switched = light.step(noisy(person, rng))
    assert not switched
    assert gain is None or np.abs(gain - 1).max() < 0.05
    gain, switched = light.step(noisy(factor * person, rng))
    assert switched
    assert gain == pytest.approx(np.full_like(gain, factor), abs=0.05)
    again, switched = light.step(noisy(factor * person, rng))
    assert not switched
    assert np.abs(again - gain).max() < 0.03


def test_a_lamp_at_one_side_is_allowed():
    scene = wall().clip(0, 150)
    side = np.linspace(1, 1.5, scene.shape[1])[None, :, None].astype(np.float32)
    gain, _ = Light(scene.astype(np.uint8)).step((side * scene).astype(np.uint8))
    assert np.abs(gain - side).max() < 0.06


def test_a_gain_stays_between_black_and_white():
    picture = np.full((4, 4, 3), 200, np.uint8)
    assert lit(picture, None) is picture
    assert (lit(picture, np.full((4, 4, 3), 2, np.float32)) == 255).all()
