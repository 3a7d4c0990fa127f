import shutil
from dataclasses import replace

import pytest
from rich.console import Console

from silpose.app.summary import results, summarise
from silpose.recording.runs.finished_run import FinishedRun


def test_names_are_whole_in_a_narrow_terminal(tmp_path):
    values = {
        "mean_joint_distance": 1.64,
        "heading_median_deg": 4.8,
        "heading_over_20deg": 0.04,
        "back_after_blank": 1.0,
        "back_after_cut": 0.82,
    }
    run = FinishedRun(tmp_path, "hypotheses", "data", {"tracker_given_start": values}, {}, "")
    console = Console(width=80, record=True)
    console.print(results(run))
    told = console.export_text()
    assert all(value in told for value in ("tracker_given_start", "1.64", "4.8°", "100%", "82%"))


def test_no_table_is_half_empty(tmp_path):
    kinds = {
        kind: {"frames_by_neighbours": 0.25, "found_by_modes": 0.5} for kind in ("arms", "legs")
    }
    metrics = kinds | {"two_modes": {"frames": 0.125, "error_of_first": 3.5}}
    run = FinishedRun(tmp_path, "ambiguity", "data", metrics, {}, "")
    first, second = results(run).renderables
    assert [first.row_count, second.row_count] == [2, 1]
    assert [len(first.columns), len(second.columns)] == [3, 3]
    assert first.title and not second.title


@pytest.mark.parametrize("width", [40, 60, 80])
def test_no_value_is_cut_in_a_narrow_terminal(tmp_path, width):
    values = {
        "mean_angular_error_deg": 10.25,
        "heading_median_deg": 104.5,
        "heading_over_20deg": 0.99,
        "mpjpe_mm": 1234.0,
        "silhouette_iou": 0.75,
        "coverage_angles": 1.0,
    }
    methods = {"fitted_take_shape_given": values, "oracle": values}
    run = FinishedRun(tmp_path, "fitting", "data", methods, {}, "")
    console = Console(width=width, record=True)
    console.print(results(run, width))
    told = console.export_text()
    assert "…" not in told
    assert max(map(len, told.splitlines())) <= width
    for value in ("10.25°", "104.5°", "99%", "1234 mm", "0.75", "100%", "fitted_take_shape_given"):
        assert told.count(value) >= 1 + (value[0].isdigit())


def test_a_table_says_what_it_is_and_explains_its_words(finished, capsys):
    summarise(replace(finished, experiment="extinction"))
    told = capsys.readouterr().out
    assert "errors of the tracker on an unseen take" in told
    assert "pose kernel" in told
    assert "off by 20°: frames whose heading is wrong by more than 20°" in told
    assert "oracle: the training pose nearest to the true one" in told


def test_a_report_is_printed_as_it_is(tmp_path, capsys):
    (tmp_path / "report.txt").write_text("joints  [root] Hips\n" + "word " * 60, encoding="utf-8")
    summarise(FinishedRun(tmp_path, "motion_report", "walks", {}, {"motion": 1.0}, ""))
    told = capsys.readouterr().out
    assert "joints  [root] Hips\n" + "word " * 59 in told
    assert "errors on unseen takes" not in told


def test_a_further_table_leaves_out_rows_that_have_nothing_in_it(tmp_path):
    both = {"mean_angular_error_deg": 4.5, "heading_median_deg": 9.0}
    methods = {"tracker_given_start": both | {"kept": 0.18}, "mean_pose": both}
    run = FinishedRun(tmp_path, "tracking", "data", methods, {}, "")
    first, second = results(run, 42).renderables
    assert [first.row_count, second.row_count] == [2, 1]


def test_a_report_stands_for_the_summary(finished, tmp_path, capsys):
    shutil.copytree(finished.folder, tmp_path / "run")
    run = replace(finished, folder=tmp_path / "run", metrics={}, summary="3 masks")
    summarise(run)
    assert "3 masks" in capsys.readouterr().out
    (tmp_path / "run" / "report.txt").write_text("masks 3 of one size")
    summarise(run)
    told = capsys.readouterr().out
    assert "masks 3 of one size" in told and "3 masks" not in told
