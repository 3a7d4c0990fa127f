import shutil
from dataclasses import replace

import pytest
from rerun.chunk import RrdReader

from silpose.core.errors import InputError
from silpose.recording import compare, read_poses
from silpose.recording import entity_paths as entities
from silpose.recording.viewer.screenshots import opened


@pytest.fixture
def twin(finished, tmp_path):
    """The same run under another name."""
    folder = shutil.copytree(finished.folder, tmp_path / "twin")
    return replace(finished, folder=folder)


def test_runs_stand_side_by_side(finished, twin, tmp_path):
    compare([finished, twin], tmp_path / "both.rrd")
    found = {chunk.entity_path for chunk in RrdReader(tmp_path / "both.rrd").stream()}
    for run in ("small", "twin"):
        assert f"/{run}{entities.TRUE_SKELETON}" in found
        assert f"/{run}{entities.ERROR}/rvm_20" in found
    both = read_poses(tmp_path / "both.rrd")
    assert set(both) == {
        f"{run}/{name}" for run in ("small", "twin") for name in ("true", "estimated")
    }
    assert {poses.shape for poses in both.values()} == {(45, 55)}


def test_differences_of_settings_are_a_table(finished, twin, tmp_path):
    other = replace(twin, config=f"{twin.config}more: 7\n")
    for run, words in ((twin, "no setting differs"), (other, "| twin | 7 |")):
        compare([finished, run], tmp_path / "both.rrd")
        texts = RrdReader(tmp_path / "both.rrd").stream().filter(content=entities.METRICS)
        assert words in str([chunk.to_record_batch().to_pydict() for chunk in texts])


def test_opens_without_an_error(finished, twin, tmp_path, drawing):
    compare([finished, twin], tmp_path / "both.rrd")
    with opened(tmp_path / "both.rrd") as viewer:
        viewer.set_time("frame", sequence=1, play_state="paused")
        viewer.take_screenshot()
        views = viewer.get_state().views
    assert {view.name: list(view.reports) for view in views if view.reports} == {}


def test_what_cannot_be_compared_is_named(finished, twin, tmp_path):
    other = replace(twin, experiment="tracking")
    for runs, match in (
        ([finished], "at least two runs"),
        ([finished, finished], "called 'small'"),
        ([finished, other], "single_image and tracking"),
    ):
        with pytest.raises(InputError, match=match):
            compare(runs, tmp_path / "no.rrd")
    with pytest.raises(InputError, match="no method 'foo'; it has mean_pose"):
        compare([finished, twin], tmp_path / "no.rrd", method="foo")
    (twin.folder / "run.rrd").unlink()  # as with recording=none
    with pytest.raises(InputError, match="there is no recording"):
        compare([finished, twin], tmp_path / "no.rrd")
    assert not list(tmp_path.glob("*.rrd")) and not list(tmp_path.glob(".*"))


def test_a_place_that_cannot_be_written_to_is_named(finished, twin, read_only):
    with pytest.raises(InputError, match=r"cannot write '.*both\.rrd'"):
        compare([finished, twin], read_only / "both.rrd")
