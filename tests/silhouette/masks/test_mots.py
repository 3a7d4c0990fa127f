import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.masks import read_masks
from silpose.silhouette.masks.mots import is_mots

LINES = {"person": "2001 2", "car": "1005 1"}


def test_people_are_read_frame_by_frame(tmp_path):
    file = tmp_path / "0002.txt"
    shown = ((1, "person"), (1, "car"), (2, "car"), (4, "person"))
    file.write_text("\n\n".join(f"{frame} {LINES[kind]} 2 3 222" for frame, kind in shown))
    assert is_mots(file)
    masks = read_masks(file).masks
    expected = np.array([[0, 1, 0], [0, 1, 0]])
    assert [mask.any() for mask in masks] == [True, False, False, True]
    np.testing.assert_array_equal(masks[0], expected)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("1 1005 1 2 3 222", "holds no people: in MOTS their class is 2"),
        ("1 2001 2 2 3 222\n2 2001", "line 2 of .* is incomplete"),
        ("0 0.5 0.5 7.1 0.1", "is text, which is read in the forms of MOTS and YOLO only"),
    ],
)
def test_what_is_no_mots_is_named(tmp_path, text, message):
    file = tmp_path / "a.txt"
    file.write_text(text)
    with pytest.raises(InputError, match=message):
        read_masks(file)
