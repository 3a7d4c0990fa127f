from dataclasses import replace

import cv2
import numpy as np
import pytest
from rerun.chunk import RrdReader
from video_steps import video_steps

from silpose.evaluation.gait import GaitReport, Stride
from silpose.recording import entity_paths as entities
from silpose.recording import read_recording, record_video, video_recording

FRAMES, LOST = 6, (2,)
STRIDE = Stride("left", 0.1, 0.15, 0.2, 0.25, 0.3, 1.2, 0.6, 0.1, 1.0, 0.0, False, 1.0, (2, 5))


@pytest.fixture(scope="module")
def steps(sequence):
    return video_steps(sequence, FRAMES, LOST)


@pytest.fixture(scope="module")
def recording(tmp_path_factory, steps, header):
    path = tmp_path_factory.mktemp("video") / "v.rrd"
    report = GaitReport((), (STRIDE,), (), (), "forward", ())
    record_video(header(path), iter(steps), (96, 96), 15.0, report=report)
    return path


def images_of(recording, logged, entity):
    data = logged(recording, entity, "EncodedImage:blob")
    flat = [np.array(own, np.uint8).ravel() for own in data]
    return [cv2.imdecode(own, cv2.IMREAD_UNCHANGED) for own in flat]


def test_every_frame_has_its_picture_and_its_mask(recording, logged, steps):
    pictures = images_of(recording, logged, entities.PICTURE)
    assert [picture.shape for picture in pictures] == [(96, 96, 3)] * FRAMES
    masks = images_of(recording, logged, entities.MASK)
    for mask, step in zip(masks, steps, strict=True):
        assert (mask[..., 3] > 0).sum() == step.mask.sum()


def test_outline_and_skeleton_are_where_the_step_has_them(recording, logged, steps):
    lines = logged(recording, entities.OVERLAID_OUTLINE, "LineStrips2D:strips")
    assert np.array(lines[0][0]) == pytest.approx(steps[0].outline[[0, 1, 2, 0]])
    bones = np.array(logged(recording, entities.OVERLAID_SKELETON, "LineStrips2D:strips")[0])
    assert steps[0].skeleton.min(axis=0) == pytest.approx(bones.min(axis=(0, 1)), abs=1e-3)


def test_bodies_walk_from_where_they_are_first_seen(recording, logged):
    skeletons = logged(recording, entities.FITTED_SKELETON, "LineStrips3D:strips")
    assert [bool(own) for own in skeletons] == [k not in LOST for k in range(FRAMES)]
    feet = [np.array(skeletons[k])[..., 1].min() for k in (0, 3)]
    assert feet == pytest.approx([0, 0], abs=0.2)  # metres
    paths = logged(recording, entities.PATH, "Points3D:positions")
    path = np.array([own[0] for k, own in enumerate(paths) if k not in LOST])
    assert path == pytest.approx(np.array([[0.1 * k, 0, 0] for k in (0, 1, 3, 4, 5)]), abs=1e-6)
    pelvis = entities.below(entities.FITTED_BODY, "0")
    moved = np.array(logged(recording, pelvis, "Transform3D:translation")).reshape(FRAMES, 3)
    assert np.isnan(moved).all(axis=1).tolist() == [k in LOST for k in range(FRAMES)]
    assert moved[3, 0] - moved[0, 0] == pytest.approx(0.3, abs=1e-5)


def test_poses_and_times_are_read_back(recording, steps):
    found = read_recording(recording)
    assert found.time == pytest.approx(np.arange(FRAMES) / 15)
    x = np.concatenate([step.poses.x for step in steps])
    assert found.poses["fitted"] == pytest.approx(x, nan_ok=True, abs=1e-3)


def test_states_are_recorded_where_they_change(recording, logged):
    states = logged(recording, entities.STATE, "StateChange:state")
    assert states == [["tracking"], ["lost"], ["tracking"]]
    masks = logged(recording, entities.MASK_STATE, "StateChange:state")
    assert masks == [["person"], ["blank"], ["person"]]


def test_the_gait_phase_is_known_within_strides(recording, logged):
    entity = entities.below(entities.GAIT_PHASE, "left")
    phase = np.ravel(logged(recording, entity, "Scalars:scalars")).astype(float)
    assert np.isnan(phase).tolist() == [True, True, False, False, False, True]
    assert phase[3] == pytest.approx(50)


def test_the_gait_phase_has_a_gap_where_a_stride_follows_another(tmp_path, steps, header, logged):
    path, later = tmp_path / "two.rrd", replace(STRIDE, start=0.3, end=0.5)
    report = GaitReport((), (STRIDE, later), (), (), "forward", ())
    record_video(header(path), iter(steps), (96, 96), 15.0, report=report)
    entity = entities.below(entities.GAIT_PHASE, "left")
    assert logged(path, entity, "frame") == [0, 1, 2, 3, 4, 5, 5]
    phase = logged(path, entity, "Scalars:scalars")
    assert [len(row) for row in phase] == [1, 1, 1, 1, 1, 0, 1]


def test_masks_alone_keep_no_picture(tmp_path, steps, header, logged):
    file = tmp_path / "private.rrd"
    record_video(header(file), steps, (96, 96), 15.0, keep_pictures=False)
    assert entities.PICTURE not in {chunk.entity_path for chunk in RrdReader(file).stream()}
    ((opacity,),) = logged(file, entities.MASK, "EncodedImage:opacity", static=True)
    assert opacity < 1  # else the viewer draws black where nobody is, in a light theme, too


def test_a_live_recording_is_complete_though_it_was_cut_short(tmp_path, steps, header, logged):
    file = tmp_path / "live.rrd"
    with video_recording(header(file), (96, 96), 15.0, live=True) as recorder:
        for step in steps[:4]:
            recorder.log(replace(step, latency=0.04, dropped=2))
        recorder.finish("the end", {"fitted": {"iou": 0.9}})
    latency = np.ravel(logged(file, entities.LATENCY, "Scalars:scalars"))
    assert latency == pytest.approx([40] * 4)
    captions = np.ravel(logged(file, entities.CAPTION, "Points2D:labels"))
    assert captions[0] == "tracking   confidence 0.80   40 ms   2 dropped"
    words = logged(file, entities.METRICS, "TextDocument:text", static=True)
    assert "the end" in str(words[-1])
    assert list(tmp_path.iterdir()) == [file]


@pytest.mark.parametrize("background", [48, 224])  # of labels in the viewer's themes, grey values
def test_captions_are_read_in_the_dark_and_in_the_light(recordings, logged, background):
    ((packed,),) = logged(recordings["video"], entities.CAPTION, "Points2D:colors", static=True)
    colour = np.array([packed >> 24 & 255, packed >> 16 & 255, packed >> 8 & 255])
    linear, behind = ((np.array(c) / 255) ** 2.2 for c in (colour, [background] * 3))
    weights = np.array([0.2126, 0.7152, 0.0722])
    low, high = sorted(float(weights @ c) + 0.05 for c in (linear, behind))
    assert high / low > 2.5
