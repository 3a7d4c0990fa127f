import re

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.motion.capture.folder_files import motion_files


def tree(root, *names):
    for name in names:
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).touch()


def names(root, *formats):
    return [file.relative_to(root).as_posix() for file in motion_files(root, formats)]


def refusal(root, *formats):
    with pytest.raises(InputError) as error:
        motion_files(root, formats)
    return str(error.value)


def test_endings_in_any_case_sorted_by_name(tmp_path):
    tree(tmp_path, "b/2.bvh", "1.BVH", "a/3.Bvh", "4.amc", "5.npz", "notes.txt", "bvh")
    assert names(tmp_path, "bvh") == ["1.BVH", "b/2.bvh", "a/3.Bvh"]
    assert names(tmp_path, "bvh", "amc") == ["1.BVH", "b/2.bvh", "a/3.Bvh", "4.amc"]


def test_hidden_files_are_skipped(tmp_path):
    tree(tmp_path, "a.bvh", "._a.bvh", ".git/b.bvh", "__MACOSX/._a.bvh", "__MACOSX/a.bvh")
    assert names(tmp_path, "bvh") == ["a.bvh"]


def test_a_root_may_be_below_a_hidden_folder(tmp_path):
    tree(tmp_path, ".cache/a.bvh")
    assert names(tmp_path / ".cache", "bvh") == ["a.bvh"]


def test_links_are_followed_and_loops_are_not(tmp_path):
    tree(tmp_path, "data/a.bvh", "elsewhere/b.bvh")
    (tmp_path / "data" / "more").symlink_to(tmp_path / "elsewhere")
    (tmp_path / "data" / "loop").symlink_to(tmp_path / "data")
    (tmp_path / "elsewhere" / "back").symlink_to(tmp_path / "elsewhere")
    (tmp_path / "data" / "z").mkdir()
    (tmp_path / "data" / "z" / "c.bvh").touch()
    (tmp_path / "data" / "a_second_way").symlink_to(tmp_path / "data" / "z")
    (tmp_path / "data" / "broken.bvh").symlink_to(tmp_path / "nothing")
    assert names(tmp_path / "data", "bvh") == ["a.bvh", "more/b.bvh", "z/c.bvh"]
    (tmp_path / "link").symlink_to(tmp_path / "data")
    assert len(names(tmp_path / "link", "bvh")) == 3


def test_archives_without_motion_are_skipped(tmp_path, small_amass):
    small_amass(tmp_path / "a_poses.npz")
    np.savez(tmp_path / "shape.npz", betas=np.zeros(16))
    np.savez(tmp_path / "neutral_stagei.npz", markers_latent=np.zeros((4, 3)))
    (tmp_path / "damaged.npz").write_bytes(b"PK")
    assert names(tmp_path, "npz") == ["a_poses.npz", "damaged.npz"]
    (tmp_path / "a_poses.npz").unlink()
    (tmp_path / "damaged.npz").unlink()
    assert "its 2 .npz files hold no motion" in refusal(tmp_path, "npz")


def test_a_single_file(tmp_path):
    tree(tmp_path, "a.NPZ", "b.asf", "c.fbx")
    assert motion_files(tmp_path / "a.NPZ", ["bvh"]) == [tmp_path / "a.NPZ"]
    assert "give its .amc file" in refusal(tmp_path / "b.asf", "bvh")
    assert "export it as BVH" in refusal(tmp_path / "c.fbx", "bvh")


@pytest.mark.parametrize(
    ("there", "formats", "said"),
    [
        (["a.npz"], ["bvh", "amc"], "no .bvh or .amc files .*its 1 .npz files are .*motion=amass"),
        (["a.bvh", "b.bvh"], ["npz"], r"2 .bvh files are read by motion=bvh .*formats=\['bvh'\]"),
        (["a.fbx"], ["bvh"], "1 .fbx files cannot be read"),
        (["a.zip"], ["bvh"], "1 .zip files cannot be read as they are: unpack them"),
        (["a.pkl"], ["npz"], "save their poses"),
        (["a.asf"], ["bvh", "amc"], "put its .amc files beside it"),
        (["notes.txt"], ["bvh"], "give a folder that holds motion capture"),
        ([], ["bvh"], "no .bvh files in this folder"),
    ],
)
def test_what_there_is_instead(tmp_path, there, formats, said):
    tree(tmp_path, *there)
    assert re.search(said, refusal(tmp_path, *formats))


def test_no_such_folder(tmp_path):
    assert "no such folder" in refusal(tmp_path / "nowhere", "bvh")
