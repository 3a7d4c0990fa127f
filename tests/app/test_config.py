import inspect
from functools import partial
from itertools import product

import pytest
from omegaconf import OmegaConf

from silpose.app.config import build, config_folder, load
from silpose.core.errors import InputError
from silpose.dataset import CrossCamera, CrossPerformer, SamePerformer, SceneSampler
from silpose.descriptor import ShapeContextHistogram
from silpose.motion import MotionFolder, WalkerTakes
from silpose.regression import BasisSettings, RidgeSettings, RvmSettings
from silpose.silhouette import Body, Camera, Degradation

CHOICES = sorted(
    (file.parent.name, file.stem)
    for file in config_folder().glob("*/*.yaml")
)  # fmt: skip
NEEDED = {
    "agarwal": ["dataset.path=somewhere"],
    "amass": ["motion.root=somewhere"],
    "bvh": ["motion.root=somewhere"],
    "masks": ["silhouette.source=somewhere"],
}


@pytest.mark.parametrize(("group", "choice"), CHOICES)
def test_every_choice_composes(group, choice):
    settings = load([f"{group}={choice}", *NEEDED.get(choice, [])])
    assert OmegaConf.to_container(settings, resolve=True, throw_on_missing=True)


def test_every_pair_of_motion_and_silhouette_composes():
    for motion, silhouette in product(("walker", "bvh"), ("convex", "wooden", "masks")):
        overrides = [f"motion={motion}", f"silhouette={silhouette}"]
        assert load([*overrides, *NEEDED.get(motion, []), *NEEDED.get(silhouette, [])])


def test_an_added_setting_is_refused_and_its_neighbour_named():
    with pytest.raises(InputError, match=r"no setting 'motion\.frame_per_second'.*did you mean"):
        load(["+motion.frame_per_second=3"])


def test_a_misspelt_setting_is_refused_and_its_neighbour_named():
    with pytest.raises(InputError, match=r"no setting 'motion\.secnds'; did you mean"):
        load(["motion.secnds=3"])


def test_a_wrong_name_or_type_is_named():
    def room(size: int = 1, names: list[str] | None = None, width: float | None = None) -> tuple:
        return size, names, width

    assert build(room, {"size": 3, "names": ["a"], "width": 2}, "room") == (3, ["a"], 2.0)
    assert build(room, {"names": None}, "room") == (1, None, None)
    with pytest.raises(InputError, match=r"no setting 'room\.sise'; did you mean 'size'"):
        build(room, {"sise": 3}, "room")
    with pytest.raises(InputError, match=r"'room\.size' is to be a whole number, not 'big'"):
        build(room, {"size": "big"}, "room")


def test_what_must_be_given_is_asked_for():
    def room(root: str) -> str:
        return root

    with pytest.raises(InputError, match=r"'room\.root' is not set"):
        build(room, {}, "room")


def test_conf_holds_the_constructors_own_defaults():
    plain = OmegaConf.to_container(load(), resolve=True)
    cross_performer, cross_camera, folder = (
        OmegaConf.to_container(load(choice), resolve=True)
        for choice in (
            ["dataset=cross_performer"],
            ["dataset=cross_camera"],
            ["motion=bvh", "motion.root=somewhere"],
        )
    )
    pairs = [
        (SceneSampler, plain["silhouette"]["scenes"]),
        (CrossPerformer, cross_performer["dataset"]),
        (CrossCamera, cross_camera["dataset"]),
        (partial(MotionFolder, "somewhere"), folder["motion"]),
        (WalkerTakes, plain["motion"]),
        (Camera, plain["silhouette"]["camera"]),
        (Body, plain["silhouette"]["body"]),
        (Degradation, plain["silhouette"]["degradation"]),
        (SamePerformer, plain["dataset"]),
        (ShapeContextHistogram, plain["descriptor"]),
        (BasisSettings, plain["regression"]["basis"]),
        (RidgeSettings, plain["regression"]["ridge"]),
        (RvmSettings, plain["regression"]["rvm"]),
    ]
    for constructor, settings in pairs:
        parameters, made = inspect.signature(constructor).parameters, constructor()
        for name, value in settings.items():
            if name in parameters:
                own = getattr(made, name, parameters[name].default)
                same = own == value or str(own) == value or list(own) == value
                assert same, f"{type(made).__name__}.{name}"
