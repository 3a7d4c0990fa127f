import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.masks import image_files, read_masks
from silpose.silhouette.masks.folders import choose_files


def names(files):
    return [file.name for file in files]


def bright(figures, pattern="{}.png"):
    return {pattern.format(k): 255 * mask for k, mask in enumerate(figures)}


def test_what_systems_leave_behind_is_passed_over(folder_of, figures):
    folder = folder_of(bright(figures))
    for name in ("._0.png", ".hidden.png", "Thumbs.db", "desktop.ini"):
        (folder / name).write_bytes(b"x")
    (folder / "x.png").mkdir()
    (folder / "7.png").symlink_to(folder / "nowhere.png")
    (folder / "8.png").symlink_to(folder / "0.png")
    (folder / "readme.txt").write_text("x")
    expected = [*(f"{k}.png" for k in range(6)), "8.png"]
    assert names(image_files(folder)) == expected
    chosen = choose_files(folder, lambda files: True)
    assert names(chosen.files) == expected and chosen.doubts == ()
    assert set(chosen.ignored) == {
        "7.png: a link to nothing",
        "readme.txt: no image",
        "x.png: a folder",
    }


def test_a_folder_that_is_none_or_empty(tmp_path):
    assert image_files(tmp_path) == []
    with pytest.raises(InputError, match=r"there is no folder '.*missing'"):
        image_files(tmp_path / "missing")
    with pytest.raises(InputError, match=r"holds no masks: expected \.png"):
        read_masks(tmp_path)


def test_photos_beside_masks_are_left_out_and_named(folder_of, figures, photo):
    folder = folder_of(bright(figures, "{}_mask.png"))
    for k in range(6):
        cv2.imwrite(str(folder / f"{k}.jpg"), photo)
    with pytest.warns(
        UserWarning, match=r"6 files such as '0_mask\.png' were taken and 6 left out"
    ):
        read = read_masks(folder)
    assert len(read) == 6
    assert read.ignored == tuple(f"{k}.jpg: look like no masks" for k in range(6))
    np.testing.assert_array_equal(read.masks, figures)


def test_of_two_kinds_that_look_like_no_masks_the_larger_is_taken(folder_of, figures):
    folder = folder_of(bright(figures[:2], "a_{}.png") | bright(figures[:3], "b_{}.png"))
    chosen = choose_files(folder, lambda files: False)
    assert names(chosen.files) == ["b_0.png", "b_1.png", "b_2.png"]


def test_a_cover_beside_masks_is_left_out(folder_of, figures, photo):
    folder = folder_of(bright(figures) | {"cover.png": photo})
    with pytest.warns(UserWarning, match=r"look like no masks: 'cover\.png'"):
        assert len(read_masks(folder)) == 6


def test_of_copies_those_without_loss_are_taken(folder_of, figures):
    folder = folder_of(bright(figures) | bright(figures, "{}.jpg"))
    with pytest.warns(UserWarning, match=r"'0\.png' were taken and 6 left out that have the same"):
        assert read_masks(folder).names == [f"{k}.png" for k in range(6)]


def test_a_take_may_change_its_suffix(folder_of, figures):
    folder = folder_of(bright(figures[:3]) | {f"{k}.bmp": 255 * figures[k] for k in (3, 4, 5)})
    np.testing.assert_array_equal(read_masks(folder).masks, figures)


def test_several_takes_in_a_folder_are_chosen_by_a_pattern(folder_of, figures):
    folder = folder_of(bright(figures, "left_{}.png") | bright(figures, "right_{}.png"))
    with pytest.raises(InputError, match=r"6 like 'left_0\.png', 6 like 'right_0.* in quotes"):
        read_masks(folder)
    np.testing.assert_array_equal(read_masks(folder / "right_*.png").masks, figures)
    with pytest.raises(InputError, match="no file or folder"):
        read_masks(folder / "up_*.png")


def test_names_without_order_are_one_take_and_it_is_said(folder_of, figures):
    words = ("a1b2c3", "1f00aa", "zz", "9b_4", "x7y8", "k", "e5", "0d1e")
    folder = folder_of({f"{word}.png": 255 * figures[0] for word in words})
    with pytest.warns(UserWarning, match=r"no order in time: they are read from '0d1e\.png'"):
        assert len(read_masks(folder)) == 8


def test_a_photo_in_the_middle_of_a_take_is_an_error_that_names_it(folder_of, figures, photo):
    folder = folder_of(bright(figures) | {"3.png": photo})
    with pytest.raises(InputError, match=r"'3\.png' of '.*masks' is in colours, and 5 others"):
        read_masks(folder)
    folder = folder_of({"3.png": photo[..., 0]})
    with pytest.raises(
        InputError, match=r"'3\.png' of '.*masks' is no mask, but a picture of many"
    ):
        read_masks(folder)


def test_folders_of_folders_name_some_that_hold_masks(folder_of, figures, tmp_path):
    for take in ("001/nm-01/090", "001/nm-02/090"):
        (tmp_path / take).mkdir(parents=True)
        folder_of(bright(figures), take)
        if take.startswith("001/nm-01"):
            read = read_masks(tmp_path)  # nothing to choose from
            assert len(read) == 6 and "090" in read.notes[0]
    with pytest.raises(InputError, match=r"nm-01.090' and '.*nm-02.090': give one"):
        read_masks(tmp_path)


def test_labels_of_several_people_are_masks_too(folder_of, figures, photo):
    people = {f"{k}_mask.png": np.hstack([m, 2 * m]) for k, m in enumerate(figures)}
    folder = folder_of(people | {f"{k}.png": photo for k in range(6)})
    with pytest.raises(InputError, match="has 2 labels"):
        read_masks(folder)


@pytest.mark.parametrize("path", ["", "a\0b", "x" * 5000])
def test_paths_that_are_none_are_named(path):
    with pytest.raises(InputError, match=r"path"):
        read_masks(path)


def test_a_folder_of_arrays_is_a_take_if_each_is_one_mask(tmp_path, figures):
    for k, mask in enumerate(figures * 2):
        np.save(tmp_path / f"{k}.npy", mask > 0)
    read = read_masks(tmp_path)
    assert read.names[-1] == "11.npy"
    np.testing.assert_array_equal(read.masks, figures * 2)
    np.save(tmp_path / "12.npy", np.stack(figures))
    with pytest.raises(InputError, match=r"13 takes, '12\.npy' of 6 masks: give one"):
        read_masks(tmp_path)
    (tmp_path / "a.mp4").touch()
    with pytest.raises(InputError, match=r"holds 14 takes, .*: give one"):
        read_masks(tmp_path)


def test_takes_in_one_folder_are_read_as_one_with_a_doubt(tmp_path):
    for name in (f"cam{cam}_{k}.png" for cam in (1, 2) for k in range(3)):
        (tmp_path / name).write_bytes(b"")
    chosen = choose_files(tmp_path, lambda files: True)
    assert len(chosen.files) == 6
    assert len(chosen.doubts) == 1
    assert "2 takes, which begin with 'cam1_0.png', 'cam2_0.png'" in chosen.doubts[0]
    assert chosen.doubts[0].endswith(f"such as '{tmp_path / 'cam1_'}*.png'")
