import cv2
import pytest
from PIL import Image

from silpose.core.errors import InputError
from silpose.recording import film, picture


def test_a_frame_is_drawn(finished, tmp_path, drawing):
    picture(finished.recording, 10, tmp_path / "whole.png", width=800)
    whole = cv2.imread(str(tmp_path / "whole.png"))
    assert whole.shape[1] == 800
    assert whole.std() > 10


def test_a_stretch_moves(finished, tmp_path, drawing):
    film(finished.recording, range(0, 9, 4), tmp_path / "f.gif", view="mask", width=300)
    with Image.open(tmp_path / "f.gif") as gif:
        assert gif.n_frames == 3
    film(finished.recording, [0, 4], tmp_path / "f.mp4", view="mask", width=300)
    video = cv2.VideoCapture(str(tmp_path / "f.mp4"))
    assert int(video.get(cv2.CAP_PROP_FRAME_COUNT)) == 2


def test_what_cannot_be_drawn_is_named(finished, tmp_path, drawing):
    with pytest.raises(InputError, match="no view's title begins with 'foo'; there are"):
        picture(finished.recording, 0, tmp_path / "no.png", view="foo")
    with pytest.raises(InputError, match=r"end in \.gif or \.mp4"):
        film(finished.recording, [0], tmp_path / "f.avi")
    with pytest.raises(InputError, match=r"has no frame 5000: they are 0 to \d+"):
        picture(finished.recording, 5000, tmp_path / "no.png")
    with pytest.raises(InputError, match="has no frame -1"):
        film(finished.recording, [0, -1], tmp_path / "f.gif")
    with pytest.raises(InputError, match="one frame"):
        film(finished.recording, [], tmp_path / "f.gif")


def test_a_missing_driver_and_a_closed_folder_are_named(finished, tmp_path, read_only, monkeypatch):
    with pytest.raises(InputError, match=r"cannot write '.*p\.png'"):
        picture(finished.recording, 0, read_only / "p.png")
    panics = tmp_path / "rerun"
    panics.write_text("#!/bin/sh\necho 'Error: No graphics adapter was found!' >&2\nexit 101\n")
    panics.chmod(0o755)
    monkeypatch.setenv("RERUN_CLI_PATH", str(panics))
    with pytest.raises(InputError, match=r"No graphics adapter .*mesa-vulkan-drivers"):
        film(finished.recording, [0], tmp_path / "f.gif")
    assert [file.name for file in tmp_path.iterdir() if file.is_file()] == ["rerun"]
