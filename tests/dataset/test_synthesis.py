from dataclasses import replace

import numpy as np
import pytest
from synthetic import Takes, motion

from silpose.core.pose_space import ANGLES
from silpose.dataset import LazyMasks, Renderer, SamePerformer, SceneSampler, render_take
from silpose.motion import Motion
from silpose.silhouette import Body, Camera, Degradation

SMALL = Body(level=2), Camera(width=48, height=48)


@pytest.fixture
def renderer():
    takes = [motion(name, 12, seed=k) for k, name in enumerate("abcd")]
    return Renderer(Takes(takes), *SMALL)


def test_there_is_a_mask_for_every_pose(sequence):
    assert len(sequence) == 40
    assert sequence.x.shape == (40, 55)
    assert sequence.masks.shape == (40, 96, 96)
    assert sequence.masks.any(axis=(1, 2)).all()


def test_a_standing_camera_changes_the_heading_alone(body):
    angles = np.random.default_rng(0).uniform(-20, 20, (2, 54))
    walked = np.array([[-0.9, 0, 0], [0.9, 0, 0]])
    walk = Motion("m", "p", 15.0, angles, walked)
    take = render_take(walk, body, Camera(width=64, height=64, follow=False))
    np.testing.assert_allclose(take.x[:, 2:], angles[:, 1:])
    assert abs(ANGLES.heading(take.x) - angles[:, 0]).min() > 10


def test_an_orbiting_camera_changes_the_heading_alone():
    body, camera = SMALL
    still = render_take(motion("a", 20), body, camera)
    orbited = render_take(motion("a", 20), body, replace(camera, azimuth=30, orbit=15))
    off = (ANGLES.heading(still.x) - ANGLES.heading(orbited.x) + 180) % 360 - 180
    np.testing.assert_allclose(off, 30 + np.arange(20))
    np.testing.assert_allclose(still.x[:, 2:], orbited.x[:, 2:])


def test_a_take_knows_its_motion_and_camera():
    take = render_take(motion("a", 3), *SMALL, name="a#1")
    assert (take.name, take.source, take.camera) == ("a#1", "a", SMALL[1])


def test_training_masks_are_lazy_and_held_unless_they_need_too_much_memory(renderer, monkeypatch):
    held = SamePerformer().load(renderer)
    monkeypatch.setattr("silpose.dataset.synthesis.HELD", 0)
    lazy = SamePerformer().load(renderer)
    for one, other in zip(held.train, lazy.train, strict=True):
        assert isinstance(one.masks, LazyMasks) and isinstance(other.masks, LazyMasks)
        np.testing.assert_array_equal(np.asarray(other.masks), np.asarray(one.masks))
        assert one.masks.held and not other.masks.held
    assert isinstance(lazy.test[0].masks, np.ndarray)


def test_training_and_test_have_their_own_degradation(renderer):
    whole = SamePerformer().load(renderer)
    degradation = Degradation(train=["holes"], strength=1.0)
    hurt = SamePerformer().load(replace(renderer, degradation=degradation))
    for part, changed in (("train", True), ("validation", True), ("test", False)):
        for one, other in zip(getattr(whole, part), getattr(hurt, part), strict=True):
            assert (np.asarray(one.masks) != np.asarray(other.masks)).any() == changed
            np.testing.assert_array_equal(one.x, other.x)


def test_motion_is_read_once_however_scenes_vary(renderer):
    other = replace(renderer, scenes=SceneSampler(elevation=[20, 25]))
    elevations = [take.camera.elevation for take in SamePerformer().load(other).train]
    assert all(20 <= elevation <= 25 for elevation in elevations)
    assert other.takes is renderer.takes


def test_takes_are_rendered_again_in_other_scenes(renderer):
    test = SamePerformer().load(renderer).test
    (again,) = renderer.rerender(test, SceneSampler(elevation=[30, 35], shape=[2, 2]))
    assert again.source == test[0].source
    assert 30 <= again.camera.elevation <= 35
    np.testing.assert_array_equal(again.x, test[0].x)
    assert (again.masks != test[0].masks).any()
