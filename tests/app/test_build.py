import pytest

from silpose.app.build import build, build_alternative, build_candidates, prepare_call
from silpose.app.registry import experiment
from silpose.core.errors import InputError
from silpose.silhouette import Camera

CAMERA = "silhouette.camera"


def test_settings_become_arguments():
    assert build(CAMERA, {"width": 64, "elevation": 7}) == Camera(width=64, elevation=7.0)
    assert build_alternative("dataset", {"kind": "agarwal", "path": "somewhere"}).path
    assert build_candidates("regression.ridge", {"damping": 3}).grid == {}
    assert build_candidates("regression.ridge", {"damping": [1, 2]}).grid == {"damping": [1.0, 2.0]}


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"widht": 3}, r"no setting 'silhouette\.camera\.widht'; did you mean '.*\.width'\?"),
        ({"width": "big"}, r"'silhouette\.camera\.width' must be an integer, not 'big'"),
        ({"width": [64, 128]}, r"'silhouette\.camera\.width' must be an integer, not \[64, 128\]"),
        ({"distance": -1}, r"distance must be positive, not -1"),
        (3, r"'silhouette\.camera' has settings of its own, such as silhouette\.camera\."),
    ],
)
def test_a_wrong_name_type_or_value_is_named_in_full(settings, words):
    with pytest.raises(InputError, match=words):
        build(CAMERA, settings)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ([1, "a"], r"'regression\.rvm\.nu' must be a number or auto, not 'a'"),
        ([], r"'regression\.rvm\.nu' must be a number or auto, not \[\]"),
        (-1, r"regression\.rvm\.nu must be positive or 'auto', not -1"),
        ([1, -1], r"regression\.rvm\.nu must be positive or 'auto', not -1"),
    ],
)
def test_values_to_choose_from_are_checked_each(values, words):
    with pytest.raises(InputError, match=words):
        build_candidates("regression.rvm", {"nu": values})


def test_a_mapping_of_any_keys_goes_through_to_what_checks_it():
    settings = {"kind": "folder", "root": "x", "joints": {"left_elbow": "LFArm"}}
    assert build_alternative("motion", settings).joints == {"left_elbow": "LFArm"}
    with pytest.raises(InputError, match=r"'left_elbo'; did you mean 'left_elbow'"):
        build_alternative("motion", settings | {"joints": {"left_elbo": ["LFArm"]}})
    with pytest.raises(InputError, match=r"'motion\.joints' must be a mapping like .* not 3"):
        build_alternative("motion", settings | {"joints": 3})


def test_what_must_be_given_is_asked_for():
    for settings in ({"kind": "folder"}, {"kind": "folder", "root": "???"}):
        with pytest.raises(InputError, match=r"'motion\.root' is not set: add motion\.root=…"):
            build_alternative("motion", settings)


def test_an_unknown_alternative_is_named():
    with pytest.raises(InputError, match=r"no 'descriptor\.kind=hog'; there are shape_context"):
        build_alternative("descriptor", {"kind": "hog"})


def test_an_experiment_is_checked_before_it_runs():
    with pytest.raises(InputError, match=r"'trials' must be an integer, not 'many'"):
        prepare_call(experiment("hypotheses"), "", {"trials": "many"}, components=None)
