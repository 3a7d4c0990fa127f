from dataclasses import replace

import pytest
from synthetic import Takes, motion

from silpose.core.errors import InputError
from silpose.dataset import CrossPerformer, Renderer, SceneSampler
from silpose.motion import MotionFolder, WalkerTakes
from silpose.silhouette import Body, Camera

SMALL = Body(level=2), Camera(width=48, height=48)


def take(name, performer, frames=20):
    return replace(motion(name, frames, seed=sum(map(ord, name))), performer=performer)


def data(takes, **settings):
    splitter = CrossPerformer(settings.pop("test", ["c"]))
    return splitter.load(Renderer(Takes(takes), *SMALL, SceneSampler(**settings)))


def test_unseen_performers_test_and_nobody_validates():
    takes = [take("a1", "a"), take("b1", "b", 30), take("b2", "b", 30), take("c1", "c")]
    dataset = data(takes)
    assert {s.performer for s in dataset.train} == {"a", "b"}
    assert [s.name for s in dataset.test] == ["c1"] and not dataset.validation
    frames = {p: sum(len(s) for s in dataset.train if s.performer == p) for p in "ab"}
    assert frames == {"a": 20, "b": 20}
    assert sum(len(s) for s in data(takes, frames=90).train) == 90


def test_no_performer_is_unseen_by_the_walker():
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
def test_the_usual_performers_of_cmu(shared_mocap):
    takes = MotionFolder(shared_mocap / "cmu").takes()
    split = CrossPerformer().split({take.name: take.performer for take in takes})
    assert {name[:2] for name in split.test} == {"08", "16", "29"}
    assert {name[:2] for name in split.train} == {"02", "05", "06", "07", "35"}
