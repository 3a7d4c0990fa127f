import os
import random
import subprocess
import sys
from pathlib import Path

import cv2
import numpy as np
import pytest
from rerun.chunk import RrdReader

from silpose.recording import entities


@pytest.fixture(scope="module")
def chunks(finished):
    return list(RrdReader(finished.recording).stream())


def entity_paths():
    return {v for k, v in vars(entities).items() if k.isupper() and k not in ("ERROR", "REASONS")}


def test_verifies(finished):
    rerun = Path(sys.executable).with_name("rerun")
    shown = subprocess.run(
        [rerun, "rrd", "verify", finished.recording], capture_output=True, text=True
    )
    assert shown.returncode == 0, shown.stderr


def test_holds_every_entity_and_no_other(chunks, finished):
    found = {c.entity_path for c in chunks if not c.entity_path.startswith(("/__", "/run_"))}
    errors = {f"{entities.ERROR}/{method}" for method in finished.metrics}
    assert entity_paths() | errors <= found


def test_timelines_are_frame_and_time_and_no_clock(chunks):
    assert {name for chunk in chunks for name in chunk.timeline_names} == {"frame", "time"}


def test_the_table_of_entities_is_true():
    page = (Path(__file__).parents[2] / "recordings" / "README.md").read_text()
    for path in entity_paths():
        assert f"`{path}`" in page


def vulkan():
    places = (Path("/usr/share/vulkan/icd.d"), Path("/etc/vulkan/icd.d"))
    return any(place.is_dir() and any(place.iterdir()) for place in places)


@pytest.mark.skipif(not vulkan() and not os.environ.get("CI"), reason="no Vulkan driver")
def test_opens_in_the_viewer_without_an_error(finished, tmp_path, monkeypatch):
    from rerun.experimental import ViewerClient

    monkeypatch.setenv("PATH", str(Path(sys.executable).parent), prepend=os.pathsep)
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    with ViewerClient.spawn(headless=True, port=random.randint(20000, 30000)) as viewer:
        viewer.open(str(finished.recording))
        viewer.set_time("frame", sequence=20, play_state="paused")
        viewer.take_screenshot()  # the first one waits until everything is loaded
        picture = viewer.take_screenshot(max_size=1600)
        views = viewer.get_state().views
    assert len(views) >= 8
    reports = {view.name: [r.summary for r in view.reports] for view in views if view.reports}
    assert not reports
    seen = cv2.imdecode(np.frombuffer(picture, np.uint8), cv2.IMREAD_COLOR)
    assert seen.std() > 10  # something is painted
