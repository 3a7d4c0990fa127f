import re
from dataclasses import replace
from pathlib import Path

from silpose.recording import Header
from silpose.recording import entity_paths as entities
from silpose.recording.header import results_tables

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
    assert "/somewhere" not in texts[entities.SETTINGS]
    assert entities.SETTINGS not in header("").texts()


def test_only_settings_that_differ_from_the_defaults_are_shown():
    usual = replace(header(), defaults=SETTINGS).texts()[entities.SETTINGS]
    assert usual == "All settings have their defaults."
    other = SETTINGS.replace("seed: 3", "seed: 4").replace("[8, 16]", "[8]")
    text = replace(header(), defaults=other).texts()[entities.SETTINGS]
    assert text.endswith("```\nregression.rvm.nu=[8, 16]\nseed=3\n```\n")


def test_the_best_row_is_the_first_and_bold():
    (table,) = results_tables(
        {"knn": {"error": 2.0}, "ridge": {"error": 1.0}, "oracle": {"error": 0.5}}
    )
    methods = [line.split("|")[1].strip() for line in table.splitlines()[2:]]
    assert methods == ["**ridge**", "knn", "oracle"]


def test_columns_without_room_stand_in_tables_below():
    results = {
        "fitted_from_hypotheses": {"mean_angular_error_deg": 2.0, "heading_over_20deg": 0.1},
        "ridge": {"mean_angular_error_deg": 3.0, "mpjpe_mm": 48.0},
    }
    wide, narrow = results_tables(results, room=60), results_tables(results, room=40)
    assert [len(wide), len(narrow)] == [1, 2]
    assert narrow[0].splitlines()[0] == "| method | angles | joints |"
    assert narrow[1].splitlines()[2:] == ["| **fitted_from_hypotheses** | **10%** |"]
    for table in narrow:
        rows = [line.strip("|").replace("*", "").split("|") for line in table.splitlines()]
        assert sum(max(len(row[k].strip()) for row in rows) for k in range(len(rows[0]))) <= 40
