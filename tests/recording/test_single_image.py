import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest
from rerun.chunk import RrdReader

from silpose.core.pose_space import ANGLES
from silpose.descriptor import ShapeContextHistogram
from silpose.descriptor.context_space import ContextSpace
from silpose.recording import (
    Header,
    Truth,
    record_bridges,
    record_context_space,
    record_extinction,
    record_features,
    record_hypotheses,
    record_modes,
    record_study,
    record_tracking,
)
from silpose.recording import entity_paths as entities
from silpose.recording.viewer.screenshots import opened
from silpose.silhouette import Camera
from silpose.tracking import ManyTracks, Track


def header(path):
    results = {"rvm": {"error": 1.0}}
    return Header(path.stem, "001", path, "a sequence", "seed: 0\n", results)


# One entity below each per method, per part, per tracker, per mode.
PER_SOMETHING = (
    entities.ERROR,
    entities.FEATURES,
    entities.TRACKS,
    entities.KERNELS,
    entities.MODES,
    entities.HYPOTHESES,
)
ENTITIES = {v for k, v in vars(entities).items() if k.isupper()} - {
    entities.REASONS,
    entities.SPACE,
}


@pytest.fixture(scope="module")
def recordings(finished, sequence, tmp_path_factory):
    """One file of every kind of recording."""
    folder = tmp_path_factory.mktemp("kinds")
    kinds = (
        "study",
        "bridges",
        "features",
        "tracking",
        "extinction",
        "space",
        "modes",
        "hypotheses",
    )
    paths = [folder / f"{kind}.rrd" for kind in kinds]
    heads = list(map(header, paths))
    figure = folder / "figure.png"
    cv2.imwrite(str(figure), np.random.default_rng(0).integers(0, 255, (40, 60, 3)))
    errors = {"usual": np.arange(5.0), "narrow": np.arange(5.0)}
    record_study(heads[0], figure, errors, "errors", 15.0)
    norms = np.array([[1.0, 2.0, 3.0], [0.0, 2.0, 3.0]])
    record_bridges(heads[1], figure, norms, np.array([9.0, 8.0]))
    points = [np.argwhere(mask)[:9, ::-1].astype(np.int32) for mask in sequence.masks]
    marked = {part: [np.arange(9) % 2 > k for _ in points] for k, part in enumerate(("arm", "leg"))}
    record_features(heads[2], sequence.masks, points, marked, 15.0)
    truth = Truth.of(sequence, Camera(), {"tracker": np.zeros(len(sequence))}, ANGLES)
    states = ["starting", *["tracking"] * 20, *["lost"] * (len(sequence) - 21)]
    track = Track(sequence.x, states, np.eye(len(sequence)))
    tracks = {"ridge": sequence.x, "tracker": sequence.x}
    facing = np.linspace(-180, 180, len(sequence))
    record_tracking(heads[3], sequence, truth, tracks, track, facing, ANGLES)
    kernels = {"usual": np.eye(5), "narrow": np.zeros((5, 5))}
    record_extinction(heads[4], figure, kernels, errors, 15.0)
    few = sequence.masks[:6]
    descriptor = ShapeContextHistogram(codebook_size=9).fit(few)
    described = descriptor.describe(few)
    space = ContextSpace(
        *(c[:, :2] for c in (described[0].contexts, descriptor.codebook_)),
        [d.contexts[:, :2] for d in described],
    )
    codebook = descriptor.codebook_
    record_context_space(heads[5], few, described, space, codebook, 12, 15.0)
    weights = np.tile([0.7, 0.3], (len(sequence), 1))
    weights[::2] = [1.0, 0.0]  # where there is one answer only
    modes = np.stack([sequence.x, sequence.x[::-1]], axis=1)
    named = Truth.of(sequence, Camera(), {"best of 2": np.zeros(len(sequence))}, ANGLES)
    record_modes(heads[6], sequence, named, weights, modes, ANGLES)
    many = ManyTracks(sequence.x, states, weights, modes)
    record_hypotheses(heads[7], sequence, truth, (weights, modes), many, ANGLES)
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


def test_names_of_several_words_make_plain_paths(recordings):
    found = {c.entity_path for recording in recordings for c in RrdReader(recording).stream()}
    assert f"{entities.ERROR}/best_of_2" in found
    assert not [path for path in found if "\\" in path or " " in path]


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


def test_each_opens_in_the_viewer_without_an_error(recordings, painting):
    for recording in recordings:
        with opened(recording) as viewer:
            viewer.set_time("frame", sequence=1, play_state="paused")
            picture = viewer.take_screenshot(max_size=1600)
            views = viewer.get_state().views
        assert len(views) >= 4
        reports = {view.name: [r.summary for r in view.reports] for view in views if view.reports}
        assert not reports
        seen = cv2.imdecode(np.frombuffer(picture, np.uint8), cv2.IMREAD_COLOR)
        assert seen.std() > 10  # something is painted


def test_what_a_catalog_shows_is_in_the_file(finished):
    groups = {}
    for chunk in RrdReader(finished.recording).stream().filter(content=["/__properties/**"]):
        group = groups.setdefault(chunk.entity_path.removeprefix("/__properties/"), {})
        batch = chunk.to_record_batch()
        values = {name: batch.column(name)[0].as_py() for name in batch.schema.names[1:]}
        group |= {name: value[0] for name, value in values.items()}
    assert groups["settings"]["show"] == "rvm_20"
    assert "recording.root" not in groups["settings"]
    assert groups["metrics"]["rvm_20.mpjpe_mm"] == finished.metrics["rvm_20"]["mpjpe_mm"]
    assert groups["versions"]["rerun"].startswith("0.")


def test_a_catalog_shows_a_sweep_as_a_table(recordings):
    pytest.importorskip("datafusion", reason="rerun-sdk[catalog] is not installed")
    import rerun as rr

    with rr.server.Server(
        host="127.0.0.1", datasets={"sweep": [str(path) for path in recordings]}
    ) as server:
        client = server.client()  # alive as long as its table
        table = client.get_dataset("sweep").segment_table().to_pandas()
    assert len(table) == len(recordings)
    assert {"property:settings:seed", "property:versions:silpose"} <= set(table.columns)


def test_400_tracked_frames_fit_in_4_MB(sequence, tmp_path):
    """With masks of 256 x 256, beliefs and four methods, as the experiment draws them."""
    masks = [
        np.kron(mask, np.ones((3, 3), np.uint8))[16:272, 16:272]
        for mask in (sequence.masks[k % len(sequence)] for k in range(400))
    ]
    rng = np.random.default_rng(0)
    x = np.tile(sequence.x, (10, 1)) + rng.normal(size=(400, 55))
    take = replace(sequence, x=x, masks=np.stack(masks), offset=np.tile(sequence.offset, (10, 1)))
    errors = {f"method {k}": rng.random(400) for k in range(14)}
    truth = Truth.of(take, Camera(), errors, ANGLES)
    beliefs = rng.dirichlet(np.full(370, 0.1), 400)
    tracks = {m: x + rng.normal(size=x.shape) for m in ("ridge", "dynamics", "joint", "tracker")}
    track = Track(x, ["tracking"] * 400, beliefs)
    file = tmp_path / "run.rrd"
    record_tracking(header(file), take, truth, tracks, track, rng.uniform(-180, 180, 370), ANGLES)
    assert 2e6 < file.stat().st_size < 4e6
