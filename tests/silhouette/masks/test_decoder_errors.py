import sys
import warnings

import numpy as np
import pytest
from video_films import write_film

from silpose.silhouette.masks.decoder_errors import DecoderErrors
from silpose.silhouette.masks.video_files import read_video
from silpose.silhouette.video.film_frames import FilmFrames


@pytest.fixture
def film(tmp_path):
    """A film of moving noise."""
    noise = np.random.default_rng(0).integers(0, 255, (90, 120, 3), dtype=np.uint8)
    return write_film(tmp_path / "film.mp4", [np.roll(noise, k, 1) for k in range(40)])


def damage(film):
    """Turn bytes in the middle of a film's data."""
    data, rng = bytearray(film.read_bytes()), np.random.default_rng(1)
    start = data.index(b"mdat")
    for place in rng.integers(start + 2000, len(data) * 9 // 10, 60):
        data[place] ^= 0xFF
    film.write_bytes(data)


def test_a_film_that_is_whole_has_no_errors(film):
    assert DecoderErrors(film).doubt() == ""


def test_damage_is_said_once_by_whoever_reads_the_film(film, capfd):
    damage(film)
    doubt = DecoderErrors(film).doubt()
    assert "film.mp4' is damaged, so that its decoder makes some pictures up" in doubt
    assert read_video(film).doubts == (doubt,)
    frames = FilmFrames(film, 960)
    with pytest.warns(UserWarning, match="is damaged, so that its decoder"):
        list(frames)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        list(frames)
    assert capfd.readouterr().err == ""


def test_who_stops_reading_waits_for_nobody(film):
    frames = iter(FilmFrames(film, 960))
    next(frames)
    frames.close()
    errors = DecoderErrors(film)
    errors.stop()
    assert errors.doubt() == ""


def test_without_another_process_nothing_is_said(film, monkeypatch):
    monkeypatch.setattr(sys, "executable", "/no/such/python")
    damage(film)
    assert DecoderErrors(film).doubt() == ""
