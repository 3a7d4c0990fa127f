from itertools import product

import pytest
from omegaconf import OmegaConf

from silpose.app.build import build
from silpose.app.conf_folder import groups
from silpose.app.config import choices, load, plain
from silpose.core.errors import InputError

CHOICES = [(group, choice) for group, names in groups().items() for choice in names]
NEEDED = {
    "agarwal": ["dataset.path=somewhere"],
    "amass": ["motion.root=somewhere"],
    "bvh": ["motion.root=somewhere"],
    "masks": ["silhouette.source=somewhere"],
    "video": ["silhouette.source=somewhere"],
    "video_knn": ["silhouette.source=somewhere"],
    "video_mog2": ["silhouette.source=somewhere"],
    "video_selfie": ["silhouette.source=somewhere"],
}


@pytest.mark.parametrize(("group", "choice"), CHOICES)
def test_every_choice_composes(group, choice):
    settings = load([f"{group}={choice}", *NEEDED.get(choice, [])])
    assert OmegaConf.to_container(settings, resolve=True, throw_on_missing=True)


def test_every_pair_of_motion_and_silhouette_composes():
    for motion, silhouette in product(("walker", "bvh"), ("convex", "wooden", "masks")):
        overrides = [f"motion={motion}", f"silhouette={silhouette}"]
        assert load([*overrides, *NEEDED.get(motion, []), *NEEDED.get(silhouette, [])])


WRONG = {
    "motion.secnds=3": r"no setting 'motion\.secnds'; did you mean 'motion\.seconds'\?",
    "motion=bvh motion.root=x motion.rot=y": r"'motion\.rot'; did you mean 'motion\.root'\?",
    "motion=bvh motion.seconds=3": r"setting of motion=walker, not of motion=bvh$",
    "motion=bvh motion.xyz=3": r"no setting 'motion\.xyz'; there are formats, frame_rate, ",
    "motion.joints={left_elbow:[a]}": r"setting of motion=amass and motion=bvh: add motion=bvh$",
    "motion=bvh motion.joints=[a]": r"'motion\.joints' cannot be \[a\]: 'silpose settings' shows",
    "motion=bvh motion.joints={root:[#1]}": r"double quotes .* 'motion\.joints={left_elbow: \[\"#1",
    "motion=bvh motion.joints={root:[a]": "every bracket",
    "motion={a:1}": "'motion' takes one name: amass, bvh, walker",
    "silhouette/scenes.frames=3": r"write silhouette\.scenes\.frames=3",
    "regression=linear regression.ridge.dampin=3": r"did you mean 'regression\.ridge\.damping'\?",
    "experiment=damping vales=[1]": r"no setting 'vales'; did you mean 'values'\?",
    "+motion.frame_per_second=3": r"'motion\.frame_per_second'.*'motion\.frames_per_second'",
    "+motion=bvh": r"motion is chosen twice: write motion=… once, without '\+'",
    "+motion.seconds=3": r"'motion\.seconds' is a setting: write motion\.seconds=… without '\+'",
    "~motion.seconds": r"'motion\.seconds' cannot be deleted: leave out '~motion\.seconds'",
    "motion=walkr": r"no motion=walkr; did you mean 'walker'\?",
    "silhouette/scenes=vide": r"no silhouette/scenes=vide; did you mean 'wide'\?",
    "seed=1 nonsense": r"cannot read 'nonsense': settings are given as key=value",
}


@pytest.mark.parametrize("overrides", WRONG)
def test_what_is_misspelt_is_refused_and_its_neighbour_named(overrides):
    with pytest.raises(InputError, match=WRONG[overrides]) as refused:
        load(overrides.split())
    assert "\n" not in str(refused.value)


def test_choices_follow_the_overrides():
    assert choices()["motion"] == "walker"
    chosen = choices(["experiment=training_data"])
    assert chosen["dataset"] == "cross_performer"
    assert chosen["silhouette/scenes"] == "one"


def test_settings_hold_what_no_file_says():
    settings = plain(load(["seed=5"]))
    assert settings["regression"]["svm"]["penalty"] == 3
    assert settings["regression"]["mixture"]["random_state"] == 5
    assert settings["experiment"] == "single_image"


def test_keys_of_a_mapping_are_free():
    joints = plain(load(["motion=bvh", "motion.joints={left_elbow: [a]}"]))["motion"]["joints"]
    assert joints == {"left_elbow": ["a"]}
    for spelling in ("motion.joints.left_elbow=[a]", "+motion.joints.left_elbow=[a]"):
        assert load(["motion=bvh", spelling]).motion.joints == joints


def test_usual_names_of_joints_need_no_quotes():
    usual = "{neck: [Bip01 L Thigh, mixamorig:Hips, DEF-thigh.L.001, a|b, 01]}"
    settings = plain(load(["motion=bvh", f"motion.joints={usual}"]))
    names = ["Bip01 L Thigh", "mixamorig:Hips", "DEF-thigh.L.001", "a|b", "01"]
    assert settings["motion"]["joints"] == {"neck": names}


@pytest.mark.parametrize("group", ["regression", "regression.ridge", "silhouette.camera"])
def test_settings_build_nothing_but_our_own_classes(group, tmp_path):
    trace = tmp_path / "run"
    with pytest.raises(InputError, match="no setting"):
        load([f"+{group}._target_=os.system", f"+{group}.command='touch {trace}'"])
    with pytest.raises(InputError, match="no setting"):
        build(group, {"_target_": "os.system", "command": f"touch {trace}"})
    assert not trace.exists()
