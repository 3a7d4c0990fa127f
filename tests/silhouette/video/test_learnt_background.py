import warnings

import cv2
import numpy as np
import pytest
from video_films import overlap, wall, write_film

from silpose.core.errors import InputError
from silpose.silhouette.video import VideoMasks, open_source
from silpose.silhouette.video.backgrounds import Shadows
from silpose.silhouette.video.learnt_background import learn_background, sample_of


def learn(film, kind="median", samples=40):
    frames = open_source(film)
    sample = sample_of(frames, samples)
    return learn_background(kind, frames, sample, 500, 20, Shadows(0.6, 0.04))


def test_a_median_of_a_sample_is_the_scene(film):
    learnt = learn(film, samples=15)
    assert np.abs(learnt.background - wall()).mean() < 4


def test_a_picture_is_scaled_to_the_films_size(film, tmp_path):
    large = cv2.resize(wall().astype(np.uint8), (384, 288))
    cv2.imwrite(str(tmp_path / "empty.png"), large[:, :, ::-1])
    learnt = learn(film, str(tmp_path / "empty.png"))
    assert learnt.background.shape == (144, 192, 3)
    assert np.abs(learnt.background - wall()).mean() < 2


def test_a_picture_of_another_camera_and_two_frames_are_refused(film, tmp_path, pictures):
    cv2.imwrite(str(tmp_path / "other.png"), np.zeros((90, 90, 3), np.uint8))
    with pytest.raises(InputError, match=r"other\.png' is 90x90 and pictures of .* are 192x144"):
        learn(film, str(tmp_path / "other.png"))
    (tmp_path / "text.png").write_text("nothing")
    with pytest.raises(InputError, match="no picture that can be read"):
        learn(film, str(tmp_path / "text.png"))
    short = write_film(tmp_path / "short.mp4", pictures[:2])
    with pytest.raises(InputError, match="fewer than 3 frames, too few for a median"):
        learn(short)


def test_a_film_in_which_a_person_hardly_moves_is_doubted(film, tmp_path, pictures):
    short = write_film(tmp_path / "short.mp4", pictures[:5])
    with pytest.warns(
        UserWarning, match=r"short\.mp4' lasts 0\.2 s, .* give a picture of the empty"
    ):
        learn(short)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        learn(film)


def test_a_grey_film_has_no_shadow_rule_and_it_is_said(tmp_path, pictures):
    grey = [np.repeat(p.mean(axis=-1, keepdims=True), 3, -1).astype(np.uint8) for p in pictures]
    film = write_film(tmp_path / "grey.avi", grey, codec="FFV1")
    with pytest.warns(UserWarning, match="is grey, so shadows are not told"):
        assert learn(film).shadows is None


def test_a_light_that_is_switched_halfway_does_not_hide_the_person(tmp_path, pictures, truth):
    brighter = [(1.4 * picture).clip(0, 255).astype(np.uint8) for picture in pictures]
    film = write_film(tmp_path / "switched.mp4", [*pictures[:16], *brighter[16:]])
    video = VideoMasks(film)
    shares = [overlap(frame.mask, mask) for frame, mask in zip(video, truth, strict=True)]
    assert np.median(shares[:16]) > 0.8
    assert np.median(shares[19:]) > 0.8
