import time

import cv2
import numpy as np
import pytest
from video_films import noisy, overlap, paint, wall, write_film

from silpose.core.errors import InputError
from silpose.silhouette.masks import MaskSequence, read_masks
from silpose.silhouette.video import VideoMasks


@pytest.mark.parametrize(("background", "least"), [("median", 0.85), ("mog2", 0.8), ("knn", 0.8)])
def test_the_person_in_a_film_is_found(film, truth, background, least):
    frames = list(VideoMasks(film, background=background))
    assert [frame.index for frame in frames] == list(range(32))
    assert [frame.time for frame in frames] == pytest.approx(np.arange(32) / 25, abs=2e-3)
    assert {frame.state for frame in frames[2:-2]} == {"person"}
    found = [overlap(frame.mask, truth[frame.index]) for frame in frames]
    assert np.median(found) > least
    assert frames[3].picture.shape == (144, 192, 3)


def test_a_clip_becomes_a_sequence_of_masks(film, truth):
    video = VideoMasks(film, first=3, last=20)
    sequence = video.masks()
    assert isinstance(sequence, MaskSequence)
    assert read_masks(sequence) is sequence
    assert len(sequence) == 18
    assert sequence.frames_per_second == pytest.approx(25)
    assert sequence.names[0] == "frame 3"
    assert overlap(sequence[0], truth[3]) > 0.85
    assert len(video.masks()) == 18  # and again


def test_a_folder_gives_what_the_film_gives(tmp_path, pictures, truth):
    for k, picture in enumerate(pictures):
        cv2.imwrite(str(tmp_path / f"frame_{k}.png"), picture[:, :, ::-1])
    frames = list(VideoMasks(tmp_path, frames_per_second=25))
    assert np.median([overlap(f.mask, truth[f.index]) for f in frames]) > 0.93


def test_a_shadow_on_the_wall_is_left_out(tmp_path, truth):
    rng, pictures = np.random.default_rng(0), []
    for mask in truth:
        cast = np.roll(mask, 14, axis=1)
        cast[:, :14] = 0
        shaded = np.where(cast[..., None] > 0, 0.75 * wall(), wall())
        pictures.append(noisy(paint(shaded, mask), rng))
    film = write_film(tmp_path / "shadow.avi", pictures, codec="FFV1")
    with_rule, without = (
        np.median([overlap(f.mask, truth[f.index]) for f in VideoMasks(film, shadows=on)])
        for on in (True, False)
    )
    assert with_rule > 0.9
    assert with_rule > without + 0.1


def test_a_film_in_real_time_takes_its_time(film):
    video = VideoMasks(film, real_time=True)
    start = time.monotonic()
    frames = list(video)
    assert time.monotonic() - start > 31 / 25
    assert len(frames) + video.dropped == 32


def test_what_cannot_be_is_refused(film, monkeypatch):
    with pytest.raises(InputError, match="no frame 99"):
        list(VideoMasks(film, first=99))
    video = VideoMasks(film, background="mog2")
    video.frames.is_live = True
    with pytest.raises(InputError, match="does not end"):
        video.masks()
    assert {frame.state for frame in video} >= {"learning"}
    monkeypatch.setattr(video.frames, "is_live", True)
    monkeypatch.setattr("silpose.silhouette.video.video_masks.open_source", lambda *_: video.frames)
    with pytest.raises(InputError, match=r"no whole clip.*background='mog2'"):
        VideoMasks(0, "median")
    assert VideoMasks(0).background == "mog2"
