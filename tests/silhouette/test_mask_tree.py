import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.mask_tree import TreePattern, find_takes, is_tree


@pytest.fixture
def tree(tmp_path):
    """Two subjects, two sequences, a view; and what else there is in folders."""
    mask = np.zeros((9, 9), np.uint8)
    mask[2:7, 3:6] = 255
    for subject in ("001", "002 (Jörg, [x]=1)"):
        for sequence in ("bg-01", "nm-01"):
            folder = tmp_path / "root" / subject / sequence / "090"
            folder.mkdir(parents=True)
            for frame in range(2):
                cv2.imencode(".png", mask)[1].tofile(folder / f"{frame}.png")
    root = tmp_path / "root"
    (root / "README.txt").write_text("a data set")
    (root / ".cache").mkdir()
    (root / ".cache" / "0.png").write_bytes(b"")
    (root / "001" / "empty").mkdir()
    return root


def names(root, pattern=None):
    return [take.name for take in find_takes(root, TreePattern.of(pattern))]


def test_takes_are_folders_with_masks_at_any_depth(tree):
    other = "002 (Jörg, [x]=1)"
    assert names(tree) == [
        "001/bg-01/090",
        "001/nm-01/090",
        f"{other}/bg-01/090",
        f"{other}/nm-01/090",
    ]
    assert names(tree / "001") == ["bg-01/090", "nm-01/090"]


def test_files_of_many_masks_are_takes_too(tree):
    np.save(tree / "001" / "a.npy", np.ones((2, 4, 4)))
    np.save(tree / "001" / "b.npy", np.ones((2, 4, 4)))
    (tree / "001" / "b.mp4").write_bytes(b"")
    assert names(tree)[:3] == ["001/a", "001/b.mp4", "001/b.npy"]


def test_a_pattern_chooses_takes_and_names_levels(tree):
    assert names(tree, "subject/nm-*/view") == ["001/nm-01/090", "002 (Jörg, [x]=1)/nm-01/090"]
    assert names(tree, "*/*/000") == names(tree)  # a plain word is a name
    assert names(tree, "*/*/[0]00") == []
    assert names(tree, "subject/view") == []
    pattern = TreePattern.of("subject/nm-*/view")
    assert pattern.columns == ["subject", "level2", "view"]
    assert pattern.parts("001/nm-01/090") == ["001", "nm-01", "090"]
    for wrong, words in (("subject//view", "empty level"), ("view/view", "two levels alike")):
        with pytest.raises(InputError, match=words):
            TreePattern.of(wrong)


def test_a_folder_of_masks_is_no_tree(tree):
    assert is_tree(tree) and is_tree(tree / "001")
    assert not is_tree(tree / "001" / "nm-01" / "090")
    assert not is_tree(tree / "README.txt") and not is_tree(tree / "nowhere")
    assert not is_tree(tree / "001" / "empty")
    alone = tree / "001" / "empty"
    np.save(alone / "masks.npy", np.ones((2, 4, 4)))
    assert not is_tree(alone)  # its one file is its masks
    np.save(alone / "others.npy", np.ones((2, 4, 4)))
    assert is_tree(alone)


def test_a_link_to_a_folder_above_ends(tree):
    (tree / "001" / "again").symlink_to(tree)
    assert len(names(tree)) == len({*names(tree)}) == 4


def test_arrays_of_one_mask_each_are_one_take(tree):
    folder = tree / "001" / "empty"
    for frame in range(3):
        np.save(folder / f"{frame}.npy", np.ones((4, 4)))
    assert "001/empty" in names(tree)
    assert not is_tree(folder)
