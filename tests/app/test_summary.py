from rich.console import Console

from silpose.app.summary import results
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
