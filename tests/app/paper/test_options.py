import pytest

from silpose.app.paper import parse
from silpose.core.errors import InputError


def test_own_settings_are_told_from_those_of_experiments():
    options = parse(["paper.parts=[bridges, parts]", "paper.fast=true", "motion=bvh"])
    assert options.parts == ("bridges", "parts") and options.fast
    assert options.experiment_overrides == ("motion=bvh",)


def test_paths_are_any_text():
    assert parse(["paper.video=a: [b].mp4"]).video == "a: [b].mp4"


@pytest.mark.parametrize(
    "argument, words",
    [
        ("paper.seedz=3", "there is no setting 'paper.seedz'.*seeds"),
        ("paper.seeds=0", "positive integer"),
        ("paper.seeds=many", "must be a number"),
        ("paper.fast=1", "true or false"),
        ("fast", "key=value"),
    ],
)
def test_what_cannot_be_read_is_named(argument, words):
    with pytest.raises(InputError, match=words):
        parse([argument])
