from dataclasses import replace

import numpy as np
import pytest
from rerun.chunk import RrdReader

from silpose.recording import entity_paths as entities
from silpose.recording import palette, read_recording, record_prediction


@pytest.fixture(scope="module")
def answer(finished, mask_folder):
    """Intermediate results of twelve masks, the sixth blank, and poses, four of them doubtful."""
    details = finished.model.explain(mask_folder, blank="nan")
    poses = finished.model.predict(details)
    confidence = np.where(np.arange(12) < 4, 0.2, 0.9)
    return details, replace(poses, confidence=confidence, time=np.cumsum(np.full(12, 0.2)))


@pytest.fixture(scope="module")
def recording(tmp_path_factory, finished, answer, header):
    path = tmp_path_factory.mktemp("prediction") / "p.rrd"
    details, poses = answer
    record_prediction(header(path), finished.model, details, poses)
    return path


def test_a_blank_mask_draws_no_skeleton(recording, logged):
    for entity, component in (
        (entities.ESTIMATED_SKELETON, "LineStrips3D:strips"),
        (entities.OVERLAID_SKELETON, "LineStrips2D:strips"),
    ):
        strips = logged(recording, entity, component)
        assert [bool(np.isnan(np.array(frame)).any()) for frame in strips] == [
            frame == 5 for frame in range(12)
        ]
    drawn = np.array(logged(recording, entities.ESTIMATED_SKELETON, "LineStrips3D:strips")[6])
    assert drawn[..., 1].min() == pytest.approx(0, abs=1e-6)  # it stands on the ground


def test_the_skeleton_is_on_the_mask(recording, logged, sequence):
    strips = np.array(logged(recording, entities.OVERLAID_SKELETON, "LineStrips2D:strips")[0])
    rows, columns = (np.flatnonzero(sequence.masks[0].any(axis=axis)) for axis in (1, 0))
    assert rows[0] - 2 < strips[..., 1].min() < strips[..., 1].max() < rows[-1] + 2
    assert columns[0] - 8 < strips[..., 0].min() < strips[..., 0].max() < columns[-1] + 8


def test_doubt_is_a_colour_and_a_line(recording, logged):
    colours = logged(recording, entities.OVERLAID_SKELETON, "LineStrips2D:colors")
    red = [palette.shade(palette.DOUBTFUL, "right") in map(_rgb, frame) for frame in colours]
    assert red == [frame < 4 for frame in range(12)]
    confidence = logged(recording, entities.CONFIDENCE, "Scalars:scalars")
    assert np.ravel(confidence) == pytest.approx(np.where(np.arange(12) < 4, 0.2, 0.9))
    states = logged(recording, entities.STATE, "StateChange:state")
    assert states == [["estimated"], ["blank"], ["estimated"]]


def _rgb(packed):
    return packed >> 24, packed >> 16 & 255, packed >> 8 & 255


def test_times_are_those_of_the_masks(recording, answer):
    assert read_recording(recording).time[:12] == pytest.approx(answer[1].time)


def test_there_is_no_truth(recording):
    found = {chunk.entity_path for chunk in RrdReader(recording).stream()}
    assert not found & {entities.TRUE_SKELETON, entities.TRUE_POSE}


def test_a_model_without_calibration_has_no_confidence(tmp_path, finished, answer, header):
    details, poses = answer
    path = tmp_path / "p.rrd"
    unknown = replace(poses, confidence=np.full(12, np.nan))
    record_prediction(header(path), finished.model, details, unknown)
    assert entities.CONFIDENCE not in {c.entity_path for c in RrdReader(path).stream()}
