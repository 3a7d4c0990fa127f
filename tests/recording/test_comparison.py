import shutil
from dataclasses import replace

import pytest
from rerun.chunk import RrdReader

from silpose.errors import InputError
from silpose.recording import compare, entities, read_poses


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
    assert all(len(poses) in (45, 90) for poses in both.values())


def test_opens_without_an_error(finished, twin, tmp_path, painting):
    import random
    import sys
    from pathlib import Path

    from rerun.experimental import ViewerClient

    compare([finished, twin], tmp_path / "both.rrd")
    rerun = str(Path(sys.executable).with_name("rerun"))
    port = random.randint(20000, 30000)
    with ViewerClient.spawn(headless=True, port=port, executable_path=rerun) as viewer:
        viewer.open(str(tmp_path / "both.rrd"))
        viewer.set_time("frame", sequence=1, play_state="paused")
        viewer.take_screenshot()
        views = viewer.get_state().views
    assert {view.name: list(view.reports) for view in views if view.reports} == {}


def test_what_does_not_compare_is_said(finished, twin, tmp_path):
    other = replace(twin, experiment="tracking")
    for runs, match in (
        ([finished], "two runs"),
        ([finished, finished], "called 'small'"),
        ([finished, other], "single_image and tracking"),
    ):
        with pytest.raises(InputError, match=match):
            compare(runs, tmp_path / "no.rrd")
    with pytest.raises(InputError, match="no method 'foo'; it has mean_pose"):
        compare([finished, twin], tmp_path / "no.rrd", method="foo")
    assert not (tmp_path / "no.rrd").exists()
