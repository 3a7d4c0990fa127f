from dataclasses import replace

import pytest
from synthetic import Takes, motion

from silpose.core.errors import InputError
from silpose.core.stages import timing
from silpose.dataset import (
    AgarwalFile,
    CrossCamera,
    CrossPerformer,
    DatasetSource,
    Renderer,
    SamePerformer,
    SceneSampler,
)
from silpose.dataset.splitter import matching
from silpose.silhouette import Body, Camera

SMALL = Body(level=2), Camera(width=48, height=48)
TAKES = [motion(name, 6, seed=k) for k, name in enumerate("abcd")]


@pytest.mark.parametrize(
    ("source", "name"),
    [
        (SamePerformer(), "same_performer/synthetic"),
        (CrossPerformer(), "cross_performer/synthetic"),
        (CrossCamera(), "cross_camera/synthetic"),
        (AgarwalFile("a.mat"), "agarwal"),
    ],
)
def test_every_dataset_has_its_name_and_knows_whether_it_is_rendered(source, name):
    assert isinstance(source, DatasetSource)
    assert source.full_name(Renderer(Takes(TAKES), *SMALL)) == name
    assert source.rendered == (name != "agarwal")


def test_a_motion_under_two_names_is_refused():
    copy = replace(TAKES[0], name="copy")
    splitter = SamePerformer(test=["copy"])
    with pytest.raises(InputError, match="takes 'a' and 'copy' are the same motion"):
        splitter.load(Renderer(Takes([*TAKES, copy]), *SMALL))


def test_only_training_draws_its_scenes():
    scenes = SceneSampler(elevation=[20, 30])
    data = SamePerformer().load(Renderer(Takes(TAKES), *SMALL, scenes))
    assert all(20 <= take.camera.elevation <= 30 for take in data.train)
    for take in (*data.validation, *data.test):
        assert take.camera == SMALL[1]


def test_loading_is_a_stage():
    with timing() as seconds:
        SamePerformer().load(Renderer(Takes(TAKES), *SMALL))
    assert list(seconds) == ["masks"]


def test_globs_match_in_order():
    assert matching(["b1", "a1", "b2"], ["b?", "a*"]) == ["b1", "a1", "b2"]
    assert matching(["b1"], ["B1"]) == []
