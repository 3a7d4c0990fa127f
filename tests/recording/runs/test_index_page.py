import json
import shutil

import pytest

from silpose.recording.runs.index_page import index_page


@pytest.fixture
def root(finished, tmp_path):
    """A finished run, one without a recording, one that was cut off."""
    root = tmp_path / "runs"
    shutil.copytree(finished.folder, root / "single_image" / "whole")
    shutil.copytree(finished.folder, root / "single_image" / "<bare>")
    (root / "single_image" / "<bare>" / "run.rrd").unlink()
    (root / "single_image" / "killed").mkdir()
    (root / "single_image" / "killed" / ".run.partial.rrd").touch()
    return root


def test_runs_are_listed_with_their_headlines(root, finished):
    page = index_page(root, lambda path: f"view:{path}")
    for method in (finished.best, "mean_pose"):
        assert page.count(f"{finished.metrics[method]['mean_angular_error_deg']:.2f}°") == 2
    assert "single_image/killed was not finished" in page
    assert page.count("<button popovertarget") == 4  # a small and a large figure of each run


def test_what_differs_and_what_is_asked_is_told(root):
    config = root / "single_image" / "<bare>" / "config.yaml"
    config.write_text(config.read_text().replace("\ndebug: false", "\ndebug: true"))
    page = index_page(root, str, {"single_image": "Which pose?"})
    assert "Which pose?" in page and "debug=<wbr>true" in page and "debug=<wbr>false" in page
    assert "width=device-width" in page


def test_runs_without_figures_or_differences_have_none(root):
    for figure in root.rglob("*.png"):
        figure.unlink()
    page = index_page(root, str)
    assert "<img" not in page and "differs in" not in page


def test_only_a_run_with_a_recording_is_a_link(root):
    page = index_page(root, lambda path: f"view:{path}")
    assert '<a href="view:single_image/whole/run.rrd">whole</a>' in page
    assert page.count("view:") == 1


def test_runs_of_a_sweep_have_its_name_and_figure(root):
    sweep = root / "single_image" / "widths"
    shutil.copytree(root / "single_image" / "whole", sweep / "000")
    (sweep / "sweep.yaml").write_text("{}")
    page = index_page(root, str)
    assert ">widths/000<" in page and "Sweep" not in page
    (sweep / "sweep.png").write_bytes((sweep / "000" / "single_image.png").read_bytes())
    page = index_page(root, str)
    assert page.count("Sweep widths") == 1
    assert 'src="single_image/widths/sweep.png"' in page
    assert "Sweep" not in index_page(sweep / "000", str)


def test_names_are_escaped(root):
    page = index_page(root, str)
    assert "&lt;bare&gt;" in page
    assert "<bare>" not in page
    assert "%3Cbare%3E/single_image.png" in page


def test_an_empty_folder_has_no_runs(tmp_path):
    assert "no runs here yet" in index_page(tmp_path, str)


def test_where_no_error_is_common_no_method_is_shown(root):
    file = root / "single_image" / "whole" / "metrics.json"
    content = json.loads(file.read_text())
    content["metrics"] = {"arms": {"part_error": 3.21}, "legs": {"part_error": 4.32}}
    file.write_text(json.dumps(content))
    page = index_page(root, str)
    assert "none: no error in common" in page
    assert "3.21" not in page and "4.32" not in page
    for file in root.rglob("metrics.json"):
        file.write_text(json.dumps(content | {"metrics": {}, "summary": "12 masks"}))
    page = index_page(root, str)
    assert 'data-title="found">12 masks<' in page and ">best<" not in page
