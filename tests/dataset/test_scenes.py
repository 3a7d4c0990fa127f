import numpy as np
import pytest
from synthetic import motion

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.dataset import SceneSampler
from silpose.dataset.synthesis import synthesise
from silpose.motion import Motion
from silpose.silhouette import Body, Camera

BODY, CAMERA = Body(level=2), Camera(width=48, height=48, orbit=40.0)


def walk(name, performer, frames):
    """A walk straight towards +Z."""
    angles = np.zeros((frames, 54))
    return Motion(name, performer, 15.0, angles, np.zeros((frames, 3)))


def test_nothing_is_drawn_by_default():
    takes = [motion("a", 5), motion("b", 7)]
    shots = SceneSampler().shots(takes, BODY, CAMERA)
    assert [(s.motion, s.body, s.camera, s.name) for s in shots] == [
        (take, BODY, CAMERA, take.name) for take in takes
    ]


def test_draws_stay_in_their_ranges_and_differ():
    ranges = {"elevation": [-5, 25], "focal_length": [1.5, 2.2], "distance": [4, 6]}
    scenes = SceneSampler(frames=300, shape=[1, 2], **ranges)
    shots = scenes.shots([motion("a", 10)], BODY, CAMERA)
    assert len(shots) == 30
    for name, (low, high) in ranges.items():
        values = [getattr(shot.camera, name) for shot in shots]
        assert low <= min(values) and max(values) <= high
        assert np.ptp(values) > 0.7 * (high - low)
    lengths = [np.linalg.norm(shot.body.shape) for shot in shots]
    assert min(lengths) >= 1 and max(lengths) <= 2
    assert len({shot.body.shape for shot in shots}) == 30
    again = scenes.shots([motion("a", 10)], BODY, CAMERA)
    assert [s.camera for s in again] == [s.camera for s in shots]
    other = scenes.shots([motion("a", 10)], BODY, CAMERA, stream=1)
    assert [s.camera for s in other] != [s.camera for s in shots]


def test_every_performer_gives_the_same_number_of_frames():
    takes = [walk("a1", "a", 30), walk("a2", "a", 10), walk("b1", "b", 200), walk("c1", "c", 7)]
    for frames in (30, 100, 601):
        shots = SceneSampler(frames=frames).shots(takes, BODY, CAMERA)
        counts = {p: sum(len(s.motion) for s in shots if s.motion.performer == p) for p in "abc"}
        assert sum(counts.values()) == frames
        assert max(counts.values()) - min(counts.values()) <= 1
        assert len({shot.name for shot in shots}) == len(shots)
        of_a = [sum(len(s.motion) for s in shots if s.motion.name == n) for n in ("a1", "a2")]
        assert of_a[0] == pytest.approx(3 * of_a[1], abs=4)


def test_straight_walks_show_all_headings_evenly():
    scenes = SceneSampler(frames=3000, around=True)
    takes = [walk(f"{p}{k}", p, 40) for p in "ab" for k in range(3)]
    split = {take.name: take.performer for take in takes}
    data = synthesise([*takes, walk("t", "c", 30)], _Last(), BODY, CAMERA, "d", scenes)
    assert set(split) == {s.take for s in data.train}
    headings = np.concatenate([ANGLES.heading(s.x) for s in data.train])
    counts, _ = np.histogram(headings, 24, (-180, 180))
    assert counts.min() > 0.8 * counts.mean() and counts.max() < 1.2 * counts.mean()
    seen = np.unwrap(ANGLES.heading(data.train[0].x), period=360)
    assert abs(seen[15] - seen[0]) == pytest.approx(40)


class _Last:
    """Splits the last take off for the test."""

    def split(self, takes):
        from silpose.dataset import Split

        names = list(takes)
        return Split(names[:-1], [], names[-1:])


def test_mirrored_sequences_are_mirror_images():
    angles = np.zeros((3, 54))
    angles[:, 3] = 20
    take = Motion("m", "p", 15.0, angles, np.zeros((3, 3)))
    shots = SceneSampler(frames=12, mirror=True).shots([take], BODY, CAMERA)
    leaning = {tuple(np.round(shot.motion.angles[0], 6)) for shot in shots}
    assert len(leaning) == 2


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"frames": 0}, "scenes.frames must be 1 or more"),
        ({"elevation": [5, 1]}, r"scenes.elevation is \[lowest, highest\]"),
        ({"shape": [1]}, r"scenes.shape is \[lowest, highest\]"),
    ],
)
def test_impossible_ranges_are_named(settings, message):
    with pytest.raises(InputError, match=message):
        SceneSampler(**settings)
