from dataclasses import replace

import numpy as np
import pytest
from synthetic import motion

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.dataset import CrossPerformer, Dataset, SceneSampler, photograph, synthesise
from silpose.motion import MotionFolder, WalkerTakes
from silpose.silhouette import Body, Camera

SMALL = Body(level=2), Camera(width=48, height=48)


def take(name, performer, frames=20):
    return replace(motion(name, frames, seed=sum(map(ord, name))), performer=performer)


def data(takes, **settings):
    splitter = CrossPerformer(settings.pop("test", ["c"]))
    return synthesise(takes, splitter, *SMALL, "d", SceneSampler(**settings))


def test_strangers_test_and_nobody_validates():
    takes = [take("a1", "a"), take("b1", "b", 30), take("b2", "b", 30), take("c1", "c")]
    dataset = data(takes)
    assert {s.performer for s in dataset.train} == {"a", "b"}
    assert [s.name for s in dataset.test] == ["c1"] and not dataset.validation
    frames = {p: sum(len(s) for s in dataset.train if s.performer == p) for p in "ab"}
    assert frames == {"a": 20, "b": 20}
    assert sum(len(s) for s in data(takes, frames=90).train) == 90


def test_a_performer_on_both_sides_is_refused(sequence):
    other = replace(sequence, name="other", take="other")
    with pytest.raises(InputError, match="performer 'someone' is in two"):
        Dataset("d", ANGLES, [sequence], [], [other], by_performer=True)
    again = replace(sequence, name="again")
    with pytest.raises(InputError, match="take 'swinging' is in two"):
        Dataset("d", ANGLES, [sequence], [], [again])


def test_a_motion_under_two_names_is_refused():
    one = take("a1", "a")
    same = replace(one, name="c1", performer="c")
    with pytest.raises(InputError, match="takes 'a1' and 'c1' are the same motion"):
        data([one, take("b1", "b"), same])


def test_the_walker_is_no_stranger():
    takes = WalkerTakes(seconds=1, test_seconds=1).takes()
    with pytest.raises(InputError, match="fitted to all performers"):
        data(takes)


@pytest.mark.parametrize(
    ("test", "message"),
    [(["x"], "no performer matches 'x'.*there are a, b, c"), (["b", "c"], "fewer than two")],
)
def test_impossible_splits_are_named(test, message):
    with pytest.raises(InputError, match=message):
        CrossPerformer(test).split({"a1": "a", "b1": "b", "c1": "c"})


@pytest.mark.shared
def test_the_usual_strangers_of_cmu(shared_mocap):
    takes = MotionFolder(shared_mocap / "cmu").takes()
    split = CrossPerformer().split({take.name: take.performer for take in takes})
    assert {name[:2] for name in split.test} == {"08", "16", "29"}
    assert {name[:2] for name in split.train} == {"02", "05", "06", "07", "35"}


def test_masks_that_do_not_fit_are_taken_when_asked_for(monkeypatch):
    takes = [take("a1", "a"), take("b1", "b"), take("c1", "c")]
    held = data(takes)
    monkeypatch.setattr("silpose.dataset.synthesis.HELD", 0)
    lazy = data(takes)
    for one, other in zip(held.train, lazy.train, strict=True):
        assert isinstance(one.masks, np.ndarray) and not isinstance(other.masks, np.ndarray)
        assert len(other.masks) == len(one.masks)
        np.testing.assert_array_equal(np.asarray(other.masks), one.masks)
        np.testing.assert_array_equal(other.masks[3], one.masks[3])
        np.testing.assert_array_equal(other.masks[-1], one.masks[-1])
        np.testing.assert_array_equal(other.masks[2::5], one.masks[2::5])
    assert isinstance(lazy.test[0].masks, np.ndarray)


def test_a_camera_that_goes_round_turns_the_heading_alone():
    body, camera = SMALL
    one = take("a", "a")
    still = photograph(one, body, camera)
    round_ = photograph(one, body, replace(camera, azimuth=30, orbit=15))
    off = (ANGLES.heading(still.x) - ANGLES.heading(round_.x) + 180) % 360 - 180
    np.testing.assert_allclose(off, 30 + np.arange(20))
    np.testing.assert_allclose(still.x[:, 2:], round_.x[:, 2:])
