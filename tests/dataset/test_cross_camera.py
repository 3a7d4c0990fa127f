import numpy as np
import pytest
from synthetic import Takes, motion

from silpose.core.errors import InputError
from silpose.dataset import CrossCamera, Renderer, SceneSampler
from silpose.silhouette import Body, Camera

SMALL = Body(level=2), Camera(width=48, height=48)
TRAINING = SceneSampler(elevation=[-5, 20], focal_length=[1.6, 2.2], shape=[0, 3])


def test_the_tests_cameras_and_bodies_are_outside_the_trainings():
    takes = [motion(name, 10, seed=k) for k, name in enumerate("abcd")]
    data = CrossCamera().load(Renderer(Takes(takes), *SMALL, TRAINING))
    assert data.name == "cross_camera/synthetic"
    assert [len(part) for part in (data.train, data.validation, data.test)] == [2, 1, 1]
    for take in data.train:
        assert -5 <= take.camera.elevation <= 20
        assert 1.6 <= take.camera.focal_length <= 2.2
    (test,) = data.test
    assert 25 <= test.camera.elevation <= 35 and 1.3 <= test.camera.focal_length <= 1.5
    scenes = CrossCamera().test_scenes(TRAINING, *SMALL)
    assert all(
        3.5 <= np.linalg.norm(scene.body.shape) <= 4.5 for scene in scenes.draw(takes, *SMALL)
    )


@pytest.mark.parametrize(
    ("settings", "training", "name"),
    [
        ({"elevation": [15, 30]}, TRAINING, "elevation"),
        ({"focal_length": [2.2, 3]}, TRAINING, "focal_length"),
        ({"shape": [0, 5]}, TRAINING, "shape"),
        ({"elevation": [0, 10]}, SceneSampler(), "elevation"),
    ],
)
def test_ranges_that_meet_are_refused(settings, training, name):
    with pytest.raises(InputError, match=rf"dataset.{name} .* meets the training's"):
        CrossCamera(**settings).test_scenes(training, *SMALL)
