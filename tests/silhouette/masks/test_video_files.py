import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.masks.video_files import _uneven, read_video


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


def test_a_film_of_masks_that_is_cut_off_or_uneven_is_doubted(tmp_path):
    frames = [np.full((48, 64), 5 * k, np.uint8) for k in range(40)]
    write(tmp_path / "whole.avi", frames, 25, "MJPG")
    data = (tmp_path / "whole.avi").read_bytes()
    (tmp_path / "cut.avi").write_bytes(data[: len(data) // 2])
    assert read_video(tmp_path / "whole.avi").doubts == ()
    (doubt,) = read_video(tmp_path / "cut.avi").doubts
    assert "of 40 frames: it is cut off or damaged" in doubt
    (tmp_path / "bare.mjpeg").write_bytes(
        b"".join(cv2.imencode(".jpg", frame)[1].tobytes() for frame in frames)
    )
    assert read_video(tmp_path / "bare.mjpeg").frames_per_second is None
    even = np.arange(60) / 25
    late = np.where(even > 1, 2 * even - 1, even)
    assert not _uneven(tmp_path, even, 25) and not _uneven(tmp_path, even[::-1], 25)
    assert "come at uneven times, and are taken for 25 frames" in _uneven(tmp_path, late, 25)
