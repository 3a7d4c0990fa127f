import io
from dataclasses import replace

import cv2
import numpy as np
import pytest
from PIL import Image
from video_steps import video_steps

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.recording import Header, film, record_study, video_recording
from silpose.recording.plain_frames import PlainFrames


@pytest.fixture(scope="module")
def frames(finished):
    return PlainFrames.read(finished.recording)


def test_three_panels_stand_side_by_side(frames):
    one, other = frames.film([0, 20], width=300)
    assert one.shape == other.shape == (100, 300, 3)
    for panel in range(3):
        own = slice(100 * panel, 100 * (panel + 1))
        assert one[:, own].std() > 5
        assert (one[:, own] != other[:, own]).any()


def test_a_still_has_a_column_for_each_frame(frames):
    picture = Image.open(io.BytesIO(frames.still(count=4, size=50)))
    assert picture.size == (200, 150)


def test_a_plain_film_needs_no_driver_and_keeps_the_speed(finished, tmp_path):
    path = tmp_path / "film.gif"
    film(finished.recording, range(15), path, width=150, frames_per_second=15, plain=True)
    with Image.open(path) as gif:
        durations = []
        for frame in range(gif.n_frames):
            gif.seek(frame)
            durations.append(gif.info["duration"])
    assert sum(durations) == 1000
    film(finished.recording, [0, 1], tmp_path / "film.mp4", width=150, plain=True)
    assert int(cv2.VideoCapture(str(tmp_path / "film.mp4")).get(cv2.CAP_PROP_FRAME_COUNT)) == 2
    with pytest.raises(InputError, match="a plain film has no views"):
        film(finished.recording, [0], path, view="mask", plain=True)


def test_a_recording_without_masks_and_poses_is_refused(tmp_path):
    header = Header("study", "test", tmp_path / "run.rrd", "words")
    record_study(header, {"error": np.ones(3)}, "error", 15.0)
    with pytest.raises(InputError, match="neither masks nor poses"):
        PlainFrames.read(header.file)


def test_frames_without_a_pose_are_drawn_without_one(frames):
    x = frames.estimated.copy()
    x[:2] = np.nan
    for estimated in (x, np.full_like(x, np.nan)):
        still = replace(frames, estimated=estimated).still(2)
        assert Image.open(io.BytesIO(still)).size[0] > 0


@pytest.fixture
def walking(sequence):
    """Frames of somebody who walks through the image, as in a film, and is not seen in one."""
    mask = sequence.masks[0]
    masks = {k: np.pad(mask, [(0, 0), (60 * k, 60 * (9 - k))]) for k in range(10)}
    masks[4] = np.zeros_like(masks[4])
    return PlainFrames(masks, sequence.x[:10], None, ANGLES)


def test_who_walks_through_the_image_stays_in_the_middle(walking):
    pictures = np.array(walking.film(range(10), width=300))[:, :, :100].max(axis=-1) > 100
    assert not pictures[4, 20:].any()  # below the title
    for picture in np.delete(pictures, 4, axis=0):
        columns = np.flatnonzero(picture[20:].any(axis=0))
        assert 35 < columns.mean() < 65
        assert np.ptp(np.flatnonzero(picture[20:].any(axis=1))) > 70


def test_a_pose_that_was_drawn_on_its_mask_is_drawn_there_again(walking):
    bones = np.full((len(ANGLES.bones), 2, 2), [60.0 * 8 + 48, 30.0])
    bones[:, 1, 1] += 20
    other = replace(walking, overlay={8: bones}).film([8], 300)[0]
    changed = (other != walking.film([8], 300)[0]).any(axis=-1)
    assert changed[:, 100:200].any() and not changed[:, :100].any()


def test_poses_stay_with_their_frames_where_a_live_recording_dropped_some(
    sequence, header, tmp_path
):
    kept = [step for step in video_steps(sequence, 8, live=True) if step.index not in (2, 3)]
    with video_recording(header(tmp_path / "run.rrd"), (96, 96), 15.0, live=True) as recorder:
        for step in kept:
            recorder.log(step)
    frames = PlainFrames.read(tmp_path / "run.rrd")
    assert len(frames) == 8 and np.isnan(frames.estimated[2:4]).all()
    for step in kept:
        np.testing.assert_allclose(frames.estimated[step.index], step.poses.x[0], rtol=1e-5)
