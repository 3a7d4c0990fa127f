import csv

import numpy as np
import pytest
from rerun.chunk import RrdReader
from small_components import components_of

from silpose.core.errors import InputError
from silpose.dataset import SamePerformer
from silpose.motion import MotionFolder, WalkerTakes, save_bvh
from silpose.recording import entity_paths


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Three walks, one with names of its own, and a file that is no motion."""
    folder = tmp_path_factory.mktemp("walks")
    takes = WalkerTakes(seconds=3, test_seconds=3).takes()[:3]
    for k, take in enumerate(takes):
        save_bvh(folder / f"walk{k}.bvh", take)
    odd = folder / "walk2.bvh"
    odd.write_text(odd.read_text().replace("left_elbow", "B17").replace("right_elbow", "B18"))
    (folder / "broken.bvh").write_text("no motion")
    return folder


@pytest.fixture(scope="module")
def report(run, folder):
    return run("motion_report", components_of(SamePerformer(), MotionFolder(folder)), shown=2)


def test_each_file_is_in_the_report_with_what_was_understood(report):
    text = report.result.report
    assert text == (report.folder / "report.txt").read_text().removesuffix("\n")
    assert "4 files, 3 understood" in text
    assert report.result.summary == "3 of 4 files understood"
    assert "walk0.bvh (BVH) and 1 more\n" in text and "walk2.bvh (BVH)\n" in text
    assert "elbow B17 / B18 (by place)" in text
    assert "refused     broken.bvh: " in text
    assert str(report.folder) not in text


def test_the_table_has_a_row_per_file(report):
    with (report.folder / "takes.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [row["file"] for row in rows] == [*(f"walk{k}.bvh" for k in range(3)), "broken.bvh"]
    assert all(0.5 < float(row["speed_m_s"]) < 2 for row in rows[:3])
    assert rows[3]["notes"].startswith("refused: ")


def test_the_figure_shows_so_many_takes_and_the_first_is_recorded(report):
    axes = report.result.figure.axes
    assert len(axes) == 3 * 2
    assert "walk0.bvh" in axes[0].get_title(loc="left")
    found = {c.entity_path for c in RrdReader(report.folder / "run.rrd").stream()}
    assert {entity_paths.TRUE_SKELETON, entity_paths.FIGURE} <= found
    assert report.metrics == {} and report.rows == []


def test_views_show_an_upright_person_who_faces_right_from_the_side(report):
    front, side = report.result.figure.axes[:2]
    for axes in (front, side):
        points = np.concatenate([line.get_xydata() for line in axes.lines])
        assert -0.2 < points[:, 1].min() < 0.1 < 1.4 < points[:, 1].max() < 2
    feet = [line.get_xydata() for line in side.lines if line.get_lw() == 1.5]
    feet = [ends for ends in feet if max(ends[:, 1]) < 0.14 and np.ptp(ends[:, 0]) > 0.08]
    assert feet and all(ends[1, 0] > ends[0, 0] for ends in feet)  # from ankle to toes


def test_a_lone_file_is_read_or_its_error_is_raised(run, folder):
    one = components_of(SamePerformer(), MotionFolder(folder / "walk0.bvh"))
    text = run("motion_report", one, record=False).result.report
    assert "walk0.bvh (BVH)\n" in text and "files" not in text
    broken = components_of(SamePerformer(), MotionFolder(folder / "broken.bvh"))
    with pytest.raises(InputError, match=r"broken\.bvh"):
        run("motion_report", broken)


def test_strict_refuses_the_first_file_and_walkers_are_no_files(run, folder, walkers):
    with pytest.raises(InputError, match=r"broken\.bvh"):
        run("motion_report", components_of(SamePerformer(), MotionFolder(folder, strict=True)))
    with pytest.raises(InputError, match=r"motion_report shows files: .* 'silpose motion PATH'"):
        run("motion_report", walkers)
    with pytest.raises(InputError, match="shown must be a positive integer"):
        run("motion_report", walkers, shown=0)
