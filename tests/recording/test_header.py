import re
from pathlib import Path

from silpose.recording import Header
from silpose.recording import entity_paths as entities

SETTINGS = """\
motion:
  kind: walker
  root: null
recording:
  root: /somewhere
regression:
  rvm:
    nu: [8, 16]
seed: 3
"""


def header(settings=SETTINGS):
    results = {"rvm": {"mean_angular_error_deg": 4.25}, "ridge": {"kept": 1}}
    return Header("parts", "001", Path("run.rrd"), "a walk", settings, results)


def test_properties_make_a_row_of_a_sweep():
    properties = header().properties()
    assert properties["settings"] == {
        "motion.kind": "walker",
        "regression.rvm.nu": "[8, 16]",
        "seed": "3",
    }
    assert properties["metrics"] == {"rvm.mean_angular_error_deg": 4.25, "ridge.kept": 1.0}
    versions = properties["versions"]
    assert {"silpose", "rerun", "python"} <= set(versions)
    assert re.fullmatch(r"[0-9a-f]{12}(-dirty)?", versions.get("commit", "0123456789ab"))


def test_where_a_recording_goes_is_not_what_it_is():
    here, there = header(), header(SETTINGS.replace("/somewhere", "/elsewhere"))
    assert here.texts() == there.texts()
    assert here.properties() == there.properties()
    assert here.identity != there.identity  # yet they are two recordings


def test_texts_hold_words_settings_and_results():
    texts = header().texts()
    assert texts[entities.TAKE] == "a walk"
    assert texts[entities.METRICS].startswith("a walk\n\n| method |")
    assert "| rvm | 4.25° |" in texts[entities.METRICS]
    assert "nu:" in texts[entities.SETTINGS]
    assert "root: /somewhere" not in texts[entities.SETTINGS]
    assert entities.SETTINGS not in header("").texts()
