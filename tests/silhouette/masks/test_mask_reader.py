import warnings

import numpy as np
import pytest
from PIL import Image

from silpose.core.errors import InputError
from silpose.silhouette import MaskReader, MaskSource


def test_a_frame_brighter_than_all_before_changes_what_they_mean(figures):
    """Background subtraction begins with nothing but shadows."""
    reader = MaskReader()
    shadow = 127 * np.roll(figures[0], 9, axis=1)
    with pytest.warns(UserWarning, match="to shadows"):
        for _ in range(40):
            reader.step(shadow)
    for mask in figures:
        frame = np.where(mask, 255, shadow).astype(np.uint8)
        np.testing.assert_array_equal(reader.step(frame), mask)
    assert not reader.step(shadow).any()


def test_blank_frames_teach_nothing(figures):
    reader = MaskReader()
    assert not reader.step(np.zeros((48, 40), np.uint8)).any()
    np.testing.assert_array_equal(reader.step(255 * figures[0]), figures[0])
    assert not reader.step(np.zeros((48, 40), np.uint8)).any()


def test_a_doubt_is_said_once(figures):
    reader = MaskReader()
    with pytest.warns(UserWarning, match="the background of the stream is bright"):
        reader.step(255 - 255 * figures[0])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for mask in figures * 8:
            np.testing.assert_array_equal(reader.step(255 - 255 * mask), mask)


def test_options_are_those_of_a_source(figures):
    people = np.hstack([figures[0], 2 * figures[0]])
    with pytest.raises(InputError, match="the stream has 2 labels"):
        MaskReader().step(people)
    mask = MaskReader(MaskSource(label=2)).step(people)
    np.testing.assert_array_equal(mask, people == 2)


def test_frames_that_are_none_are_named(figures):
    reader = MaskReader()
    reader.step(figures[0])
    with pytest.raises(InputError, match="frame 1 of the stream is None"):
        reader.step(None)


def test_a_picture_in_colours_after_masks_is_named(figures, photo):
    reader = MaskReader()
    for _ in range(40):
        reader.step(255 * figures[0])
    with pytest.raises(InputError, match=r"'frame 40' (is in colours|of the stream)"):
        reader.step(photo)


@pytest.mark.parametrize("kind", ["shades", "labels", "huge labels"])
def test_nothing_is_learnt_from_a_frame_that_is_refused(figures, kind):
    reader = MaskReader()
    reader.step(figures[0])
    odd = {
        "shades": np.random.default_rng(0).normal(size=figures[0].shape),
        "labels": np.hstack([2 * figures[0][:, ::2], 3 * figures[0][:, ::2]]),
        "huge labels": 1e300 * figures[0],
    }[kind]
    with pytest.raises(InputError) as refused:
        reader.step(odd)
    assert len(str(refused.value)) < 400
    np.testing.assert_array_equal(reader.step(figures[1]), figures[1])


def test_an_image_of_several_frames_is_refused(tmp_path, figures):
    first, other = (Image.fromarray(255 * mask) for mask in figures[:2])
    first.save(tmp_path / "a.png", save_all=True, append_images=[other])
    with pytest.raises(InputError, match="frame 0 of the stream holds 2 pictures"):
        MaskReader().step(Image.open(tmp_path / "a.png"))
