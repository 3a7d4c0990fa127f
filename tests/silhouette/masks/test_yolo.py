import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.mask_tree import is_tree
from silpose.silhouette.masks import read_masks
from silpose.silhouette.masks.yolo import is_yolo, yolo_files

HEIGHT, WIDTH = 60, 40
SQUARE = "0.25 0.2 0.75 0.2 0.75 0.8 0.25 0.8"  # columns 10 to 29, rows 12 to 47
PEOPLE = {"2.txt": f"0 {SQUARE}", "10.txt": f"56 {SQUARE}\n0 {SQUARE} 0.9\n", "11.txt": ""}


@pytest.fixture
def dataset(tmp_path):
    """A data set of YOLO: texts in one folder, the pictures in another."""
    for name, text in PEOPLE.items():
        picture = np.random.default_rng(0).integers(0, 255, (HEIGHT, WIDTH, 3), np.uint8)
        for folder in ("labels", "images"):
            (tmp_path / folder).mkdir(exist_ok=True)
        (tmp_path / "labels" / name).write_text(text)
        cv2.imwrite(str(tmp_path / "images" / name.replace(".txt", ".jpg")), picture)
    return tmp_path


def test_people_are_drawn_at_the_size_of_their_pictures(dataset):
    expected = np.zeros((HEIGHT, WIDTH), np.uint8)
    expected[12:48, 10:30] = 1
    for source in (dataset / "labels", dataset):
        masks = read_masks(source)
        assert masks.names == ["2", "10", "11"]
        assert (masks[0] != expected).sum() <= 2 * (20 + 36)  # the outline, at most
        np.testing.assert_array_equal(masks[0], masks[1])
        assert not masks[2].any()
    assert not is_tree(dataset)
    assert len(read_masks(dataset / "labels" / "2.txt")) == 1


def test_from_the_pictures_the_way_to_the_texts_is_found(dataset):
    expected = read_masks(dataset / "labels").masks
    masks = read_masks(dataset / "images")
    np.testing.assert_array_equal(masks.masks, expected)
    assert masks.notes == (f"the masks are in '{dataset / 'labels'}'",)
    for folder in ("labels", "images"):  # as it is where there are several splits
        (dataset / folder).rename(dataset / "train")
        (dataset / folder).mkdir()
        (dataset / "train").rename(dataset / folder / "train")
    np.testing.assert_array_equal(read_masks(dataset / "images" / "train").masks, expected)


def test_pictures_may_be_beside_the_texts_but_masks_go_first(dataset):
    expected = read_masks(dataset).masks
    for name in PEOPLE:
        picture = name.replace(".txt", ".jpg")
        (dataset / "images" / picture).rename(dataset / "labels" / picture)
    np.testing.assert_array_equal(read_masks(dataset / "labels").masks, expected)
    for name in PEOPLE:
        mask = np.zeros((HEIGHT, WIDTH), np.uint8)
        mask[20:30, 20:30] = 255
        (dataset / "labels" / name.replace(".txt", ".jpg")).unlink()
        cv2.imwrite(str(dataset / "labels" / name.replace(".txt", ".png")), mask)
    assert [mask.sum() for mask in read_masks(dataset / "labels")] == [100] * 3


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("0 0.5 0.5 0.1 0.1", "line 1 of .* is a box, and no mask: .* -seg"),
        ("0 0.5 0.5 0.1 0.1 0.93", "line 1 of .* is a box"),
        (f"0 {SQUARE}\n0 0.5", "line 2 of .* is incomplete or damaged"),
        (f"56 {SQUARE}", "hold no people: in YOLO their class is 0"),
    ],
)
def test_what_cannot_be_read_is_named(dataset, text, message):
    (dataset / "labels" / "2.txt").write_text(text)
    with pytest.raises(InputError, match=message):
        read_masks(dataset / "labels" / "2.txt")


def test_without_the_picture_a_size_is_asked_for(dataset):
    (dataset / "images" / "10.jpg").unlink()
    with pytest.raises(InputError, match=r"no image '.*images/10\.jpg' that tells its size"):
        read_masks(dataset / "labels")
    (dataset / "images" / "10.jpg").write_bytes(b"no picture")
    with pytest.raises(InputError, match=r"10\.jpg' cannot be read"):
        read_masks(dataset / "labels")


@pytest.mark.parametrize(
    "text", ["person 0.1 0.2 0.3 0.4", "0 5 0.2 0.3 0.4", "0 a b c d", "\n", "0 0.1 0.2"]
)
def test_other_texts_are_none_of_yolo(tmp_path, text):
    (tmp_path / "1.txt").write_text(text)
    assert not is_yolo(tmp_path / "1.txt")
    (tmp_path / "2.txt").write_text(f"0 {SQUARE}")
    assert yolo_files(tmp_path) == []


def test_empty_lines_are_passed_over(dataset):
    expected = read_masks(dataset).masks
    (dataset / "labels" / "2.txt").write_text(f"0 {SQUARE}\n\n")
    np.testing.assert_array_equal(read_masks(dataset).masks, expected)
