import pytest
from omegaconf import OmegaConf

from silpose.app.config import load, plain
from silpose.app.verbs import EXPERIMENT_VERBS, help_text, overrides_of
from silpose.core.errors import InputError


@pytest.mark.parametrize(
    "path", ["-masks", "--help me", "my masks", "a,b", "[1,2]", "it's", "${seed}", "C:\\x\\", "1"]
)
def test_a_path_is_the_source_of_the_verbs_experiment(path):
    settings = plain(load(overrides_of("predict", [path, "lag=0.2"])))
    assert settings["experiment"] == "predict"
    assert settings["silhouette"]["source"] == path
    assert settings["lag"] == 0.2


def test_a_path_may_hold_an_equals_sign_if_it_exists(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a=b").mkdir()
    assert "silhouette.source='a=b'" in overrides_of("predict", ["a=b"])
    with pytest.raises(InputError, match=r"no file 'model=x'; the path comes first: silpose"):
        overrides_of("predict", ["model=x"])


def test_the_address_of_a_stream_may_hold_an_equals_sign():
    address = "rtsp://user:word@camera/stream?channel=1&subtype=0"
    settings = plain(load(overrides_of("video", [address, "silhouette.body_height=1.75"])))
    assert settings["experiment"] == "video"
    assert settings["silhouette"]["source"] == address
    assert settings["silhouette"]["body_height"] == 1.75


def test_motion_reads_files_of_all_formats_unless_told_otherwise():
    settings = plain(load(overrides_of("motion", ["my walks", "motion.formats=[npz]", "shown=3"])))
    assert settings["experiment"] == "motion_report" and settings["shown"] == 3
    assert settings["motion"]["root"] == "my walks" and settings["motion"]["formats"] == ["npz"]
    default = plain(load(overrides_of("motion", ["walk.bvh"])))
    assert default["motion"]["formats"] == ["bvh", "amc", "npz"]


def test_a_choice_of_the_verb_gives_way_to_one_that_is_typed():
    assert "motion=bvh" not in overrides_of("motion", ["walks", "motion=amass"])
    settings = plain(load(overrides_of("motion", ["walks", "motion=amass"])))
    assert settings["motion"]["root"] == "walks"


def test_a_verb_without_its_path_shows_how_it_is_typed():
    with pytest.raises(InputError, match=r"'predict' needs a path: silpose predict PATH"):
        overrides_of("predict", [])


def test_every_verb_composes():
    for verb, short_for in EXPERIMENT_VERBS.items():
        settings = load(overrides_of(verb, ["somewhere"]))
        assert OmegaConf.select(settings, short_for.source) == "somewhere"


def test_help_shows_verbs_then_groups():
    text = help_text()
    assert text.index("predict PATH") < text.index("compare RUN") < text.index("silhouette/scenes")
    assert "schema" not in text
    assert max(map(len, text.splitlines())) <= 96


def test_paths_that_the_shell_made_of_a_pattern_are_refused(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
    with pytest.raises(InputError, match=r"takes one path, not 'a' and 'b'"):
        overrides_of("masks", ["a", "b"])
