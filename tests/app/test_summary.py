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


def test_a_report_is_printed_as_it_is(tmp_path, capsys):
    (tmp_path / "report.txt").write_text("joints  [root] Hips\n" + "word " * 60, encoding="utf-8")
    summarise(FinishedRun(tmp_path, "motion_report", "walks", {}, {"motion": 1.0}, ""))
    told = capsys.readouterr().out
    assert "joints  [root] Hips\n" + "word " * 59 in told
    assert "errors on unseen takes" not in told
