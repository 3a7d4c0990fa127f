import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette import MaskFiles, read_masks
from silpose.silhouette.mask_files import mask_files, read_mask


def test_files_come_in_the_order_of_their_numbers(tmp_path):
    for number in (10, 9, 1):
        cv2.imwrite(str(tmp_path / f"frame{number}.png"), np.ones((4, 4), np.uint8))
    assert [f.stem for f in mask_files(tmp_path)] == ["frame1", "frame9", "frame10"]


@pytest.mark.parametrize("white", [1, 255])
@pytest.mark.parametrize("channels", [1, 3])
def test_any_common_encoding_gives_zeros_and_ones(tmp_path, white, channels):
    mask = np.zeros((6, 5), np.uint8)
    mask[2:4, 1:3] = 1
    image = np.repeat((mask * white)[..., None], channels, axis=2)
    cv2.imwrite(str(tmp_path / "mask.png"), image)
    np.testing.assert_array_equal(read_mask(tmp_path / "mask.png"), mask)


def test_folders_and_files_that_cannot_be_used_are_named(tmp_path):
    with pytest.raises(InputError, match="no folder"):
        mask_files(tmp_path / "missing")
    with pytest.raises(InputError, match="holds no masks"):
        mask_files(tmp_path)
    for content in (b"", b"no image at all"):
        (tmp_path / "broken.png").write_bytes(content)
        with pytest.raises(InputError, match=r"broken\.png"):
            read_mask(tmp_path / "broken.png")


def test_a_video_of_masks_is_read_as_a_folder_is(tmp_path):
    masks = np.zeros((4, 48, 64), np.uint8)
    for frame in (0, 2, 3):
        masks[frame, 8:40, 10 + 4 * frame : 40] = 1
    file = tmp_path / "masks.mp4"
    codec = cv2.VideoWriter.fourcc(*"mp4v")
    video = cv2.VideoWriter(str(file), codec, 15, (64, 48), isColor=False)
    for mask in masks:
        video.write(255 * mask)
    video.release()
    np.testing.assert_array_equal(read_masks(file), masks)
    with pytest.raises(InputError, match=r"masks\.mp4/frame 1' has no foreground"):
        MaskFiles(str(file)).read()
    np.testing.assert_array_equal(MaskFiles(str(file), blank="nan").read(), masks)
    assert MaskFiles(str(file)).names(4)[3] == "frame 3"
    (tmp_path / "broken.mp4").write_bytes(b"no video at all")
    with pytest.raises(InputError, match=r"broken\.mp4' is no video"):
        read_masks(tmp_path / "broken.mp4")


def test_a_folder_is_read_with_its_names_and_blank_masks_are_refused(mask_folder):
    with pytest.raises(InputError, match=r"5\.png' has no foreground.*silhouette\.blank=nan"):
        MaskFiles(str(mask_folder)).read()
    files = MaskFiles(str(mask_folder), blank="nan")
    masks = files.read()
    assert len(masks) == 12 and not masks[5].any()
    assert files.names(12)[9:] == ["9.png", "10.png", "11.png"]


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"blank": "skip"}, "blank must be 'error' or 'nan', not 'skip'"),
        ({"frames_per_second": 0}, "frames_per_second must be a positive number"),
    ],
)
def test_wrong_settings_are_named(settings, message):
    with pytest.raises(InputError, match=message):
        MaskFiles(**settings)


def test_without_a_source_there_is_nothing_to_read():
    with pytest.raises(InputError, match=r"add silhouette=masks silhouette\.source=FOLDER"):
        MaskFiles().read()
