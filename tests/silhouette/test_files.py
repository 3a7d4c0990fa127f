import cv2
import numpy as np
import pytest

from silpose.errors import InputError
from silpose.silhouette import mask_files, read_mask


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
