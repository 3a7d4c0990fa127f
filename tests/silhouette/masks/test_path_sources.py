import json
from pathlib import Path

import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.masks import MaskSource
from silpose.silhouette.masks.path_sources import find_pictures


def find(path):
    return find_pictures(Path(path), MaskSource())


@pytest.mark.parametrize(
    "name", ["ü é 日", "a b", "[1] (2)", "a=b,c", 'it\'s "x"', "50%03d", "a:b", "${x}", "*?", "-m"]
)
def test_any_name_is_a_path(folder_of, figures, name):
    folder = folder_of({f"{k}.png": 255 * mask for k, mask in enumerate(figures)}, name)
    assert len(find(folder).animation.pictures) == 6
    assert find(folder).source == f"'{folder}'"


def test_files_of_unknown_suffix_are_tried(tmp_path, figures):
    encoded = cv2.imencode(".png", 255 * figures[0])[1]
    (tmp_path / "mask").write_bytes(encoded.tobytes())
    (tmp_path / "mask.xyz").write_bytes(encoded.tobytes())
    for name in ("mask", "mask.xyz"):
        np.testing.assert_array_equal(
            find(tmp_path / name).animation.pictures[0].pixels, 255 * figures[0]
        )


@pytest.mark.parametrize("name", ["a.pkl", "a.pt"])
def test_pickles_are_not_opened(tmp_path, name):
    (tmp_path / name).write_bytes(b"x")
    with pytest.raises(InputError, match="could run any program"):
        find(tmp_path / name)


def test_a_home_folder_is_found(tmp_path, figures, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("USERPROFILE", str(tmp_path))
    cv2.imwrite(str(tmp_path / "a.png"), 255 * figures[0])
    assert len(find("~/a.png").animation.pictures) == 1


def test_the_only_take_of_a_folder_is_read(tmp_path, figures):
    np.save(tmp_path / "take.npy", np.stack(figures))
    found = find(tmp_path)
    assert len(found.animation.pictures) == 6
    assert found.notes == (f"the masks are in '{tmp_path / 'take.npy'}'",)


def noise(name, height=40, width=30):
    rng = np.random.default_rng(len(name))
    return cv2.imwrite(name, rng.integers(0, 255, (height, width, 3), dtype=np.uint8))


def test_annotations_beside_photos_are_read(tmp_path, figures):
    height, width = figures[0].shape
    images = [{"id": k, "file_name": f"{k}.jpg", "height": height, "width": width} for k in (1, 2)]
    own = [{"image_id": k, "segmentation": [[5, 5, 20, 5, 20, 30]]} for k in (1, 2)]
    for k in (1, 2):
        noise(str(tmp_path / f"{k}.jpg"))
    file = tmp_path / "_annotations.coco.json"
    file.write_text(json.dumps({"images": images, "annotations": own}))
    found = find(tmp_path)
    assert len(found.animation.pictures) == 2
    assert found.notes == (f"the masks are in '{file}'",)
    file.write_text("{}")  # is something else
    assert len(find(tmp_path).animation.pictures) == 2


def test_masks_are_told_from_photos_whose_names_have_nothing_in_common(tmp_path, figures):
    for k, mask in enumerate(figures):
        name = tmp_path / f"{k}_jpg.rf.{k}{'abcdefgh'[k:]}"
        noise(f"{name}.jpg")
        cv2.imwrite(f"{name}_mask.png", mask)
    found = find(tmp_path)
    assert [picture.name for picture in found.animation.pictures] == [
        f"{k}_jpg.rf.{k}{'abcdefgh'[k:]}_mask.png" for k in range(len(figures))
    ]
    assert f"{len(figures)} left out that look like no masks" in found.doubts[0]


def test_a_pattern_chooses_files_in_natural_order(folder_of, figures):
    folder = folder_of({f"{k}.png": 255 * figures[0] for k in (10, 9, 2)})
    names = [picture.name for picture in find(folder / "*.png").animation.pictures]
    assert names == ["2.png", "9.png", "10.png"]
    with pytest.raises(InputError, match="there is no file or folder"):
        find(folder / "*.bmp")


def test_a_folder_of_folders_names_two_or_reads_the_only_one(folder_of, figures):
    folder_of({})
    for name in ("a", "b"):
        folder = folder_of({"0.png": 255 * figures[0]}, f"masks/{name}").parent
        if name == "a":
            assert find(folder).notes == (f"the masks are in '{folder / 'a'}'",)
    with pytest.raises(InputError, match=r"folders of them, such as .*a' and .*b': give one"):
        find(folder)


def test_a_folder_of_several_takes_names_them(tmp_path, figures):
    np.save(tmp_path / "a.npy", np.stack(figures))
    (tmp_path / "b.json").write_text("[]")
    with pytest.raises(InputError, match=r"holds 2 takes, 'a\.npy', 'b\.json': give one"):
        find(tmp_path)
    (tmp_path / "b.json").unlink()
    np.save(tmp_path / "c.npy", figures[0])
    with pytest.raises(InputError, match=r"holds 2 takes, 'a\.npy' of 6 masks: give one"):
        find(tmp_path)


def test_the_current_folder_is_no_empty_path(folder_of, figures, monkeypatch):
    monkeypatch.chdir(folder_of({"0.png": 255 * figures[0]}))
    assert len(find(".").animation.pictures) == 1
    with pytest.raises(InputError, match="the path of the masks is empty"):
        find_pictures("", MaskSource())
