import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.masks.video_files import read_video


def write(file, frames, rate, codec="mp4v"):
    height, width = (48, 64)
    video = cv2.VideoWriter(
        str(file), cv2.VideoWriter.fourcc(*codec), rate, (width, height), isColor=False
    )
    for frame in frames:
        video.write(frame)
    video.release()


@pytest.mark.parametrize("rate", [15, 25, 29.97, 60])
@pytest.mark.parametrize("name", ["a.mp4", "co:lon %03d [1] ü.mp4"])
def test_frames_are_read_with_the_videos_own_rate(tmp_path, rate, name):
    frames = [np.full((48, 64), 20 * k, np.uint8) for k in range(5)]
    write(tmp_path / name, frames, rate)
    read = read_video(tmp_path / name)
    assert read.frames_per_second == pytest.approx(rate, rel=1e-3)
    assert [picture.name for picture in read.pictures] == [f"frame {k}" for k in range(5)]
    assert all(picture.grey and picture.lossy for picture in read.pictures)


def test_what_is_no_video_is_named_and_nothing_else_is_printed(tmp_path, capfd):
    (tmp_path / "broken.mp4").write_bytes(b"no video at all")
    with pytest.raises(InputError, match=r"broken\.mp4' is no video"):
        read_video(tmp_path / "broken.mp4")
    write(tmp_path / "none.avi", [], 25, "FFV1")
    with pytest.raises(InputError, match=r"none\.avi' (has no frames|is no video)"):
        read_video(tmp_path / "none.avi")
    assert capfd.readouterr().err == ""
