import numpy as np
import pytest
from video_steps import video_steps

from silpose.recording import record_video
from silpose.recording.recorded_masks import read_masks, read_overlay

FRAMES, LOST = 6, (2,)


@pytest.fixture(scope="module")
def steps(sequence):
    return video_steps(sequence, FRAMES, LOST)


@pytest.fixture(scope="module", params=[True, False], ids=["pictures", "masks alone"])
def film(tmp_path_factory, steps, header, request):
    path = tmp_path_factory.mktemp("film") / "v.rrd"
    record_video(header(path), steps, (96, 96), 15.0, keep_pictures=request.param)
    return path


def test_masks_come_back_as_they_were(finished):
    masks = read_masks(finished.recording)
    assert list(masks) == list(range(45))
    assert masks[0].shape == (96, 96) and set(np.unique(masks[0])) == {0, 1}


def test_masks_of_films_come_back_as_they_were(film, steps):
    masks = read_masks(film)
    assert list(masks) == list(range(FRAMES))
    for mask, step in zip(masks.values(), steps, strict=True):
        np.testing.assert_array_equal(mask, step.mask)


def test_the_skeleton_on_the_mask_comes_back_as_it_was(film, steps):
    bones = read_overlay(film)
    assert bones[0].min(axis=(0, 1)) == pytest.approx(steps[0].skeleton.min(axis=0), abs=1e-3)
