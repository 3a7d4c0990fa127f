import numpy as np
import pytest
from synthetic import Takes, motion

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.dataset import Renderer, SceneSampler, Split, Splitter
from silpose.motion import Motion
from silpose.silhouette import Body, Camera

BODY, CAMERA = Body(level=2), Camera(width=48, height=48, orbit=40.0)


def walk(name, performer, frames):
    """A walk straight towards +Z."""
    angles = np.zeros((frames, 54))
    return Motion(name, performer, 15.0, angles, np.zeros((frames, 3)))


def test_nothing_is_drawn_by_default():
    takes = [motion("a", 5), motion("b", 7)]
    drawn = SceneSampler().draw(takes, BODY, CAMERA)
    assert [(s.motion, s.body, s.camera, s.name) for s in drawn] == [
        (take, BODY, CAMERA, take.name) for take in takes
    ]


def test_draws_stay_in_their_ranges_and_differ():
    ranges = {"elevation": [-5, 25], "focal_length": [1.5, 2.2], "distance": [4, 6]}
    sampler = SceneSampler(frames=300, shape=[1, 2], **ranges)
    drawn = sampler.draw([motion("a", 10)], BODY, CAMERA)
    assert len(drawn) == 30
    for name, (low, high) in ranges.items():
        values = [getattr(scene.camera, name) for scene in drawn]
        assert low <= min(values) and max(values) <= high
        assert np.ptp(values) > 0.7 * (high - low)
    lengths = [np.linalg.norm(scene.body.shape) for scene in drawn]
    assert min(lengths) >= 1 and max(lengths) <= 2
    assert len({scene.body.shape for scene in drawn}) == 30
    again = sampler.draw([motion("a", 10)], BODY, CAMERA)
    assert [s.camera for s in again] == [s.camera for s in drawn]
    other = sampler.draw([motion("a", 10)], BODY, CAMERA, stream=1)
    assert [s.camera for s in other] != [s.camera for s in drawn]


def test_every_performer_gives_the_same_number_of_frames():
    takes = [walk("a1", "a", 30), walk("a2", "a", 10), walk("b1", "b", 200), walk("c1", "c", 7)]
    for frames in (30, 100, 601):
        drawn = SceneSampler(frames=frames).draw(takes, BODY, CAMERA)
        counts = {p: sum(len(s.motion) for s in drawn if s.motion.performer == p) for p in "abc"}
        assert sum(counts.values()) == frames
        assert max(counts.values()) - min(counts.values()) <= 1
        assert len({scene.name for scene in drawn}) == len(drawn)
        of_a = [sum(len(s.motion) for s in drawn if s.motion.name == n) for n in ("a1", "a2")]
        assert of_a[0] == pytest.approx(3 * of_a[1], abs=4)


def test_straight_walks_show_all_headings_evenly():
    scenes = SceneSampler(frames=3000, around=True)
    takes = [walk(f"{p}{k}", p, 40) for p in "ab" for k in range(3)]
    source = Takes([*takes, walk("t", "c", 30)])
    data = _Last().load(Renderer(source, BODY, CAMERA, scenes))
    assert {take.name for take in takes} == {take.source for take in data.train}
    headings = np.concatenate([ANGLES.heading(s.x) for s in data.train])
    counts, _ = np.histogram(headings, 24, (-180, 180))
    assert counts.min() > 0.8 * counts.mean() and counts.max() < 1.2 * counts.mean()
    seen = np.unwrap(ANGLES.heading(data.train[0].x), period=360)
    assert abs(seen[15] - seen[0]) == pytest.approx(40)


class _Last(Splitter):
    """The last take is the test."""

    name = "last"

    def split(self, performers):
        names = list(performers)
        return Split(names[:-1], [], names[-1:])


def test_every_other_pair_of_takes_is_mirrored():
    angles = np.zeros((3, 54))
    angles[:, 3:5] = 20, 10
    take = Motion("m", "p", 15.0, angles, np.zeros((3, 3)))
    drawn = SceneSampler(frames=12, mirror=True).draw([take], BODY, CAMERA)
    leaning = [scene.motion.angles[0, 3] for scene in drawn]
    np.testing.assert_allclose(leaning, [20, 20, 20, 20])
    swayed = [scene.motion.angles[0, 4] for scene in drawn]
    np.testing.assert_allclose(swayed, [10, 10, -10, -10], atol=1e-6)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"frames": 0}, "scenes.frames must be at least 1"),
        ({"elevation": [5, 1]}, r"scenes.elevation must be \[lowest, highest\]"),
        ({"shape": [1]}, r"scenes.shape must be \[lowest, highest\]"),
    ],
)
def test_impossible_ranges_are_named(settings, message):
    with pytest.raises(InputError, match=message):
        SceneSampler(**settings)
