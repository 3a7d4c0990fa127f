import os
import random
import re
import subprocess
import sys
from pathlib import Path

import cv2
import numpy as np
import pytest
from rerun.chunk import RrdReader

from silpose.descriptor import ShapeContextHistogram
from silpose.pose import ANGLES
from silpose.recording import (
    ContextSpace,
    Truth,
    entities,
    record_bridges,
    record_context_space,
    record_extinction,
    record_features,
    record_modes,
    record_study,
    record_tracking,
    texts,
)
from silpose.silhouette import Camera
from silpose.tracking import Track

TEXTS = texts("a sequence", "seed: 0\n", {"rvm": {"error": 1.0}})
# One entity below each per method, per part, per tracker, per mode.
PER_SOMETHING = (
    entities.ERROR,
    entities.FEATURES,
    entities.TRACKS,
    entities.KERNELS,
    entities.MODES,
)
ENTITIES = {v for k, v in vars(entities).items() if k.isupper()} - {
    entities.REASONS,
    entities.SPACE,
}


@pytest.fixture(scope="module")
def recordings(finished, sequence, tmp_path_factory):
    """One file of every kind of recording."""
    folder = tmp_path_factory.mktemp("kinds")
    kinds = ("study", "bridges", "features", "tracking", "extinction", "space", "modes")
    paths = [folder / f"{kind}.rrd" for kind in kinds]
    figure = folder / "figure.png"
    cv2.imwrite(str(figure), np.random.default_rng(0).integers(0, 255, (40, 60, 3)))
    errors = {"usual": np.arange(5.0), "narrow": np.arange(5.0)}
    record_study(paths[0], "study", figure, errors, "errors", 15.0, TEXTS)
    norms = np.array([[1.0, 2.0, 3.0], [0.0, 2.0, 3.0]])
    record_bridges(paths[1], "bridges", figure, norms, np.array([9.0, 8.0]), TEXTS)
    points = [np.argwhere(mask)[:9, ::-1].astype(np.int32) for mask in sequence.masks]
    marked = {part: [np.arange(9) % 2 > k for _ in points] for k, part in enumerate(("arm", "leg"))}
    record_features(paths[2], "features", sequence.masks, points, marked, 15.0, TEXTS)
    truth = Truth.of(sequence, Camera(), {"tracker": np.zeros(len(sequence))}, ANGLES)
    states = ["starting", *["tracking"] * 20, *["lost"] * (len(sequence) - 21)]
    track = Track(sequence.x, states, np.eye(len(sequence)))
    tracks = {"ridge": sequence.x, "tracker": sequence.x}
    record_tracking(paths[3], "tracking", sequence, truth, tracks, track, ANGLES, TEXTS)
    kernels = {"usual": np.eye(5), "narrow": np.zeros((5, 5))}
    record_extinction(paths[4], "extinction", figure, kernels, errors, 15.0, TEXTS)
    few = sequence.masks[:6]
    descriptor = ShapeContextHistogram(codebook_size=9).fit(few)
    described = descriptor.describe(few)
    space = ContextSpace(
        *(c[:, :2] for c in (described[0].contexts, descriptor.codebook_)),
        [d.contexts[:, :2] for d in described],
    )
    codebook = descriptor.codebook_
    record_context_space(paths[5], "space", few, described, space, codebook, 12, 15.0, TEXTS)
    weights = np.tile([0.7, 0.3], (len(sequence), 1))
    weights[::2] = [1.0, 0.0]  # where there is one answer only
    modes = np.stack([sequence.x, sequence.x[::-1]], axis=1)
    record_modes(paths[6], "modes", sequence, truth, weights, modes, ANGLES, TEXTS)
    return [finished.recording, *paths]


def entities_of(recording):
    """Give the entities of a recording, those that stand for many by what is above them."""
    found = {c.entity_path for c in RrdReader(recording).stream()}
    found = {
        path for path in found if not path.startswith("/__") and path not in ("/", "/run_info")
    }
    return {
        next((above for above in PER_SOMETHING if path.startswith(f"{above}/")), path)
        for path in found
    }


def test_each_verifies(recordings):
    rerun = Path(sys.executable).with_name("rerun")
    for recording in recordings:
        shown = subprocess.run([rerun, "rrd", "verify", recording], capture_output=True, text=True)
        assert shown.returncode == 0, shown.stderr


def test_together_they_hold_every_entity_and_no_other(recordings):
    assert set().union(*map(entities_of, recordings)) == ENTITIES


def test_a_run_is_measured_by_every_method(finished):
    found = {c.entity_path for c in RrdReader(finished.recording).stream()}
    assert {f"{entities.ERROR}/{method}" for method in finished.metrics} <= found


def test_timelines_are_frame_and_time_and_no_clock(recordings):
    for recording in recordings:
        chunks = RrdReader(recording).stream()
        assert {name for c in chunks for name in c.timeline_names} == {"frame", "time"}


def test_the_table_of_entities_is_true():
    page = (Path(__file__).parents[2] / "recordings" / "README.md").read_text()
    named = {path.split("/<")[0] for path in re.findall(r"`(/[^`]+)`", page)}
    assert named == ENTITIES


def test_each_opens_in_the_viewer_without_an_error(recordings, tmp_path, monkeypatch, painting):
    from rerun.experimental import ViewerClient

    monkeypatch.setenv("PATH", str(Path(sys.executable).parent), prepend=os.pathsep)
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    for recording in recordings:
        with ViewerClient.spawn(headless=True, port=random.randint(20000, 30000)) as viewer:
            viewer.open(str(recording))
            viewer.set_time("frame", sequence=1, play_state="paused")
            viewer.take_screenshot()  # the first one waits until everything is loaded
            picture = viewer.take_screenshot(max_size=1600)
            views = viewer.get_state().views
        assert len(views) >= 4
        reports = {view.name: [r.summary for r in view.reports] for view in views if view.reports}
        assert not reports
        seen = cv2.imdecode(np.frombuffer(picture, np.uint8), cv2.IMREAD_COLOR)
        assert seen.std() > 10  # something is painted
