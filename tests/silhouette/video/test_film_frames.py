import struct
import warnings
from types import SimpleNamespace

import cv2
import numpy as np
import pytest
from PIL import Image
from video_films import write_film

from silpose.core.errors import InputError
from silpose.silhouette.video import film_frames
from silpose.silhouette.video.film_frames import FilmFrames


def grey(levels, height=48, width=64):
    return [np.full((height, width, 3), level, np.uint8) for level in levels]


@pytest.mark.parametrize("rate", [15, 29.97, 60])
def test_frames_come_with_their_times_and_again_when_read_again(tmp_path, rate):
    film = FilmFrames(
        write_film(tmp_path / "co:lon %03d ü.mp4", grey(range(0, 200, 20)), rate), 960
    )
    assert film.frames_per_second == pytest.approx(rate, rel=1e-3)
    for _ in range(2):
        frames = list(film)
        assert [frame.index for frame in frames] == list(range(10))
        assert [frame.time for frame in frames] == pytest.approx(np.arange(10) / rate, abs=2e-3)
        assert [int(frame.picture.mean()) for frame in frames] == pytest.approx(
            list(range(0, 200, 20)), abs=6
        )


def test_a_sample_is_spread_over_the_film(tmp_path):
    film = FilmFrames(write_film(tmp_path / "a.mp4", grey(np.arange(240))), 960)
    frames = list(film.sample(6))
    assert [frame.index for frame in frames] == [20, 60, 100, 140, 180, 220]
    seen = [frame.picture.mean() for frame in frames]
    assert seen == pytest.approx([20, 60, 100, 140, 180, 220], abs=8)
    assert len(list(film.sample(1000))) == 240


def test_a_film_of_a_turned_phone_is_upright(tmp_path):
    pictures = grey([100] * 3)
    for picture in pictures:
        picture[:, :32] = 220  # bright at the left
    file = write_film(tmp_path / "phone.mp4", pictures)
    data = bytearray(file.read_bytes())
    matrix = data.index(b"tkhd") + 4 + 40  # of a track header of version 0
    turned = (0, 1 << 16, 0, -(1 << 16), 0, 0, 0, 0, 1 << 30)  # by 90 degrees, clockwise
    data[matrix : matrix + 36] = struct.pack(">9i", *turned)
    file.write_bytes(data)
    film = FilmFrames(file, 960)
    picture = next(iter(film)).picture
    assert film.size == picture.shape[:2] == (64, 48)
    assert picture[:20].mean() > 200 > 120 > picture[-20:].mean()


def test_pixels_that_are_not_square_are_made_so(tmp_path, monkeypatch):
    file = write_film(tmp_path / "dv.mp4", grey([100] * 60))
    monkeypatch.setattr(film_frames, "_aspect_of", lambda capture: 1.5)
    film = FilmFrames(file, 960)
    assert film.size == (48, 96)
    for frames in (list(film), list(film.sample(9))):
        assert frames and {frame.picture.shape for frame in frames} == {(48, 96, 3)}
    assert FilmFrames(file, 48).size == (24, 48)


@pytest.mark.parametrize(
    ("told", "aspect"), [((0, 0), 1), ((1, 1), 1), ((64, 45), 64 / 45), ((1, 1000), 1)]
)
def test_a_film_tells_the_aspect_of_its_pixels(told, aspect):
    known = dict(zip((cv2.CAP_PROP_SAR_NUM, cv2.CAP_PROP_SAR_DEN), told, strict=True))
    capture = SimpleNamespace(get=known.__getitem__)
    assert film_frames._aspect_of(capture) == pytest.approx(aspect)


def test_a_film_without_a_container_tells_no_rate(tmp_path):
    pictures = [cv2.imencode(".jpg", picture)[1].tobytes() for picture in grey([50, 100, 150])]
    file = tmp_path / "bare.mjpeg"
    file.write_bytes(b"".join(pictures))
    with pytest.warns(UserWarning, match=r"'.*bare\.mjpeg' tells no frame rate, so 25 frames"):
        film = FilmFrames(file, 960)
    assert film.frames_per_second == 25
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert FilmFrames(file, 960, 90.0).frames_per_second == 90


def test_what_cannot_be_decoded_is_named_with_a_remedy(tmp_path, capfd):
    (tmp_path / "empty.mp4").write_bytes(b"")
    (tmp_path / "text.mp4").write_bytes(b"no video at all")
    film = write_film(tmp_path / "av1.mp4", grey([9] * 5))
    film.write_bytes(film.read_bytes().replace(b"mp4v", b"av01").replace(b"esds", b"free"))
    for name, words in [
        ("empty.mp4", "is empty"),
        ("text.mp4", "no video that can be read, or cut off: copy it anew, or convert it"),
        ("av1.mp4", "cannot be decoded, its codec is (AV1|av01|AV01): convert it, as by ffmpeg"),
        ("missing.mp4", "there is no file"),
    ]:
        with pytest.raises(InputError, match=words) as caught:
            FilmFrames(tmp_path / name, 960)
        assert name in str(caught.value)
    assert capfd.readouterr().err == ""


def test_a_film_that_is_cut_off_is_said(tmp_path):
    rng = np.random.default_rng(0)
    noise = [rng.integers(0, 255, (48, 64, 3), np.uint8) for _ in range(40)]
    file = write_film(tmp_path / "cut.avi", noise, codec="MJPG")
    film = FilmFrames(file, 960)
    film.announced = 100
    with pytest.warns(UserWarning, match="ends after 40 of 100 frames"):
        list(film)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        list(FilmFrames(file, 960))


@pytest.mark.filterwarnings("ignore")  # it is shorter than announced
def test_a_film_ends_where_its_pictures_change_their_size(tmp_path, monkeypatch):
    film = FilmFrames(write_film(tmp_path / "a.mp4", grey([90] * 3)), 960)
    pictures = iter([*grey([90]), *grey([90], height=30), *grey([90])])
    capture = SimpleNamespace(
        read=lambda: (True, next(pictures)), get=lambda key: 0.0, release=lambda: None
    )
    monkeypatch.setattr(film_frames, "open_capture", lambda source: capture)
    assert len(list(film)) == 1


def test_frames_at_uneven_times_have_them(tmp_path):
    durations = [40, 40, 120, 40, 200, 40, 40]
    images = [Image.fromarray(picture) for picture in grey(range(0, 210, 30))]
    file = tmp_path / "uneven.gif"
    images[0].save(file, save_all=True, append_images=images[1:], duration=durations)
    times = [frame.time for frame in FilmFrames(file, 960)]
    assert times == pytest.approx(np.cumsum([0, *durations[:-1]]) / 1000, abs=0.011)
