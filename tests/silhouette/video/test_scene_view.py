import numpy as np
from video_films import noisy, paint, wall

from silpose.silhouette.video.scene_view import SceneView, gradient


def test_light_is_no_detail_and_people_are_left_out(truth):
    scene = wall().astype(np.uint8)
    view, brighter = SceneView.of(scene, None), SceneView.of(scene + np.uint8(30), None)
    np.testing.assert_allclose(view.detail, brighter.detail, atol=0.6)
    person = truth[10]
    without = SceneView.of(paint(scene, person), person)
    assert (without.weight[person > 0] == 0).all()
    assert (without.detail[person > 0] == 0).all()
    assert without.weight.mean() > 0.6


def test_a_mask_of_nearly_everything_is_not_believed():
    everything = np.ones((144, 192), np.uint8)
    assert SceneView.of(wall().astype(np.uint8), everything).weight.all()


def test_a_shift_back_shows_the_same(truth):
    scene = noisy(wall(200, 300), np.random.default_rng(0), 12)
    one, other = (SceneView.of(scene[20:164, x : x + 192], None) for x in (20, 24))
    moved, weight = one.compared(other, np.array([-4.0, 0.0]))
    inside = weight[10:-10, 20:-20] > 0
    off = (moved - one.detail)[10:-10, 20:-20][inside]
    assert np.abs(off).mean() < 1.0
    assert weight[:, :3].max() == 0  # out of the other's sight
    across, down = gradient(one.detail, one.weight)
    np.testing.assert_allclose(
        across[20, 20], (one.detail[19:22, 21] - one.detail[19:22, 19]) @ [1, 2, 1] / 8, rtol=1e-4
    )
    assert down.shape == one.detail.shape
