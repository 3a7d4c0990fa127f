import numpy as np
import pytest
from synthetic import Takes, motion

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.dataset import Renderer, SamePerformer, SceneSampler
from silpose.dataset.views import course, seen_from
from silpose.motion import Motion
from silpose.silhouette import Body, Camera

VIEWS = [0.0, 90.0, 180.0]


def turning(frames, rate, sway):
    """A walk on a circle, in which the body sways once a second."""
    seconds = np.arange(frames) / 15
    angles = np.zeros((frames, 54))
    angles[:, 0] = (170 + rate * seconds + sway * np.sin(2 * np.pi * seconds) + 180) % 360 - 180
    return Motion("circle", "a", 15.0, angles, np.zeros((frames, 3)))


def test_the_course_is_the_heading_without_its_sway():
    found = course(turning(90, 40.0, 0.0))
    np.testing.assert_allclose(found, 170 + 40 * np.arange(90) / 15)
    swaying = course(turning(90, 40.0, 5.0))
    assert np.abs(swaying - found)[:-4].max() < 0.8


@pytest.mark.parametrize("frames", [1, 2, 5, 90])
def test_the_sway_stays_and_frames_are_divided(frames):
    parts = seen_from(turning(frames, 40.0, 5.0), VIEWS, 0.0, 1)
    assert sum(map(len, parts)) == frames
    assert len(parts) == min(frames, 3)
    if frames == 90:
        assert [part.name for part in parts] == ["circle@90", "circle@180", "circle@0"]
        for part, view in zip(parts, (90, 180, 0), strict=True):
            assert part.angles[:, 0].mean() == pytest.approx(view, abs=1)
            assert np.ptp(part.angles[:, 0]) == pytest.approx(10, abs=1.5)


def test_the_view_of_a_passing_person_changes():
    (part,) = seen_from(turning(30, 40.0, 0.0), [90.0], 20.0, 0)
    np.testing.assert_allclose(part.angles[:, 0], np.linspace(80, 100, 30))


def test_all_parts_of_a_dataset_are_in_views():
    walks = [motion(name, 30, seed=k) for k, name in enumerate("abc")]
    scenes = SceneSampler(views=VIEWS, view_change=10.0, elevation=[0, 13])
    camera = Camera(width=48, height=48, orbit=40.0)
    data = SamePerformer().load(Renderer(Takes(walks), Body(level=0), camera, scenes))
    takes = [*data.train, *data.validation, *data.test]
    assert len(takes) == 9
    assert len({take.name for take in takes}) == 9
    assert {take.source for take in takes} == {"a", "b", "c"}
    for take in takes:
        view = float(take.name.split("@")[1])
        away = (ANGLES.heading(take.x) - view + 180) % 360 - 180
        assert np.abs(away).max() < 15


def test_views_of_many_frames_have_names_of_their_own():
    scenes = SceneSampler(views=VIEWS, frames=200).draw([motion("a", 30)], Body(), Camera())
    assert sum(len(scene.motion) for scene in scenes) == 200
    assert len({scene.name for scene in scenes}) == len(scenes)


@pytest.mark.parametrize("wrong", [{"views": []}, {"views": VIEWS, "around": True}])
def test_views_that_cannot_be_are_refused(wrong):
    with pytest.raises(InputError, match="views needs at least one view"):
        SceneSampler(**wrong)
