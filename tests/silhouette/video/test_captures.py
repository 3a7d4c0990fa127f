from pathlib import Path

import pytest

from silpose.core.errors import InputError
from silpose.silhouette.video.captures import name_of, open_capture


@pytest.mark.parametrize(
    ("source", "words"),
    [
        (97, "no camera 97"),
        ("udp://[::1", "no stream at 'udp"),
        ("rtsp://127.0.0.1:9/live", "no stream at 'rtsp"),
        (Path("nowhere.mp4"), "no file 'nowhere.mp4'"),
    ],
)
def test_what_cannot_be_opened_is_named(source, words, capfd):
    with pytest.raises(InputError, match=words):
        open_capture(source)
    assert capfd.readouterr().err == ""


def test_an_empty_film_is_named(tmp_path):
    (tmp_path / "a.mp4").write_bytes(b"")
    with pytest.raises(InputError, match=r"a\.mp4' is empty"):
        open_capture(tmp_path / "a.mp4")


def test_names():
    assert [name_of(source) for source in (0, "rtsp://door")] == ["camera 0", "'rtsp://door'"]
