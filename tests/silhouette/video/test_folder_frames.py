import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.video.folder_frames import FolderFrames, read_picture


@pytest.fixture
def folder(tmp_path):
    for k in range(12):
        cv2.imwrite(str(tmp_path / f"{k}.png"), np.full((40, 60, 3), 20 * k, np.uint8))
    return tmp_path


def test_pictures_come_in_the_order_of_their_numbers(folder):
    frames = list(FolderFrames(folder, 960, 10))
    assert [frame.picture.mean() for frame in frames] == [20 * k for k in range(12)]
    assert [frame.time for frame in frames] == pytest.approx(np.arange(12) / 10)
    assert [frame.index for frame in FolderFrames(folder, 30, 10).sample(4)] == [0, 3, 6, 9]
    assert FolderFrames(folder, 30, 10).size == (20, 30)


def test_pictures_that_are_missing_are_gaps_in_time(folder):
    for k in (4, 5, 8):
        (folder / f"{k}.png").unlink()
    with pytest.warns(UserWarning, match=r"3 pictures in .* are missing .* first after '3\.png'"):
        frames = FolderFrames(folder, 960, 10)
    times = [0, 0.1, 0.2, 0.3, 0.6, 0.7, 0.9, 1.0, 1.1]
    assert [frame.time for frame in frames] == pytest.approx(times)


def test_names_that_count_from_negative_numbers_are_in_order(folder):
    for k in range(12):
        (folder / f"{k}.png").rename(folder / f"t{k - 5}.png")
    frames = list(FolderFrames(folder, 960, 10))
    assert [frame.picture.mean() for frame in frames] == [20 * k for k in range(12)]
    assert [frame.time for frame in frames] == pytest.approx(np.arange(12) / 10)


def test_grey_and_deep_pictures_are_read_too(tmp_path):
    cv2.imwrite(str(tmp_path / "a.png"), np.full((4, 6), 100 * 256, np.uint16))
    assert read_picture(tmp_path / "a.png", 960).tolist() == [[[100] * 3] * 6] * 4


def test_a_missing_rate_is_said_and_bad_pictures_are_named(folder, tmp_path):
    with pytest.warns(UserWarning, match="no frame rate, so 30"):
        FolderFrames(folder, 960)
    cv2.imwrite(str(folder / "12.png"), np.zeros((10, 10, 3), np.uint8))
    with pytest.raises(InputError, match=r"12\.png' has another size"):
        list(FolderFrames(folder, 960, 25))
    (folder / "12.png").write_bytes(b"nothing")
    with pytest.raises(InputError, match=r"12\.png' is no picture"):
        list(FolderFrames(folder, 960, 25))
    (tmp_path / "none").mkdir()
    with pytest.raises(InputError, match="no pictures in"):
        FolderFrames(tmp_path / "none", 960, 25)
