from dataclasses import replace

import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.fitting import Trace
from silpose.recording import GroundTruth, read_poses, record_fitting
from silpose.recording import entity_paths as entities
from silpose.recording.fitting import outlines_of
from silpose.silhouette import Camera


def buffer(row):
    return np.frombuffer(bytes(row[0]), np.uint8)


def test_the_overlap_shows_where_mask_and_body_are(recordings, sequence, logged):
    """The recorded bodies are the masks themselves, those before are 3 pixels to the right."""
    images = logged(recordings["fitting"], entities.OVERLAP, "SegmentationImage:buffer")
    assert len(images) == len(sequence)
    assert (buffer(images[5]).reshape(96, 96) == sequence.masks[5]).all()
    before, after = (
        np.array(logged(recordings["fitting"], entity, "LineStrips2D:strips")[5][0])
        for entity in (entities.OUTLINE_BEFORE, entities.OUTLINE)
    )
    assert before.min(axis=0) - after.min(axis=0) == pytest.approx([3, 0], abs=1)
    contours = logged(recordings["fitting"], entities.CONTOUR, "Points2D:positions")
    assert all(sequence.masks[5][int(y), int(x)] for x, y in contours[5])


def test_poses_before_and_after_are_read_back(recordings, sequence):
    poses = read_poses(recordings["fitting"])
    assert set(poses) == {"true", "estimated", "fitted"}
    assert poses["fitted"] == pytest.approx(sequence.x, abs=1e-4)
    assert poses["estimated"] == pytest.approx(sequence.x[::-1], abs=1e-4)


def test_before_and_after_stand_on_the_truth_and_the_body_beside(recordings, logged):
    def middle(entity):
        strips = logged(recordings["fitting"], entity, "LineStrips3D:strips")[0]
        return np.array(strips)[:, 0, 0].reshape(-1, len(ANGLES.bones)).mean(axis=1)

    true = middle(entities.TRUE_SKELETON)
    before, after = middle(entities.ESTIMATED_SKELETON), middle(entities.FITTED_SKELETON)
    assert [*before, *after] == pytest.approx(true, abs=0.1)
    body = f"{entities.FITTED_BODY}/0"
    place = logged(recordings["fitting"], body, "Transform3D:translation")[0][0]
    assert place[0] - true[1] == pytest.approx(0.9, abs=0.1)


def test_iterations_have_a_timeline_of_their_own(recordings):
    from rerun.chunk import RrdReader

    for chunk in RrdReader(recordings["fitting"]).stream().filter(content="/fitting/iterations/**"):
        if not chunk.is_static:
            names = chunk.to_record_batch().schema.names
            assert "iteration" in names and not {"frame", "time"} & set(names)
    costs = [
        value
        for chunk in RrdReader(recordings["fitting"])
        .stream()
        .filter(content=entities.ITERATED_COST, is_static=False)
        for value in chunk.to_record_batch().column("Scalars:scalars").to_pylist()
    ]
    assert costs == [[30.0], [9.0], [4.0]]


def test_an_outline_goes_around_a_silhouette_and_its_holes():
    ring = np.zeros((20, 20), np.uint8)
    ring[3:15, 3:15], ring[7:11, 7:11] = 1, 0
    lines = outlines_of(ring)
    assert len(lines) == 2
    assert all((line[0] == line[-1]).all() for line in lines)
    assert lines[0].min() == 3 and lines[0].max() == 14
    assert outlines_of(np.zeros((4, 4), np.uint8)) == []


def test_400_fitted_frames_fit_in_6_MB(sequence, header, tmp_path):
    """With masks of 256 x 256 and the body, as the experiment draws them."""
    masks = [
        np.kron(mask, np.ones((3, 3), np.uint8))[16:272, 16:272]
        for mask in (sequence.masks[k % len(sequence)] for k in range(400))
    ]
    rng = np.random.default_rng(0)
    x = np.tile(sequence.x, (10, 1)) + rng.normal(size=(400, 55))
    take = replace(sequence, x=x, masks=np.stack(masks), offset=np.tile(sequence.offset, (10, 1)))
    errors = {f"method {k}": rng.random(400) for k in range(4)}
    truth = GroundTruth.of(take, Camera(), errors, ANGLES)
    trace = Trace(masks[0], x[:10], masks[:10], rng.random(10), rng.random(10))
    file = tmp_path / "run.rrd"
    silhouettes = {"before": masks, "after": masks}
    record_fitting(header(file), take, truth, x, x, silhouettes, errors, trace, 0, ANGLES)
    assert 1e6 < file.stat().st_size < 6e6
