import pytest

from silpose.core.errors import InputError
from silpose.motion.capture.formats import FORMATS, read_raw


def test_formats_are_told_by_the_ending(tmp_path, small_bvh, small_amass):
    small_amass(tmp_path / "b.npz").rename(tmp_path / "b.NPZ")
    for file in (small_bvh().write(tmp_path / "a.BVH"), tmp_path / "b.NPZ"):
        assert read_raw(file).file == str(file)
    assert [read_raw(f).format for f in (tmp_path / "a.BVH", tmp_path / "b.NPZ")] == [
        "BVH",
        "AMASS",
    ]
    assert FORMATS == ("bvh", "amc", "npz")


def test_the_rate_replaces_the_files(tmp_path, small_bvh, small_amass):
    for file in (small_bvh().write(tmp_path / "a.bvh"), small_amass(tmp_path / "b.npz")):
        assert read_raw(str(file), 50.0).frames_per_second == 50


def test_other_endings(tmp_path):
    with pytest.raises(InputError, match=r"a\.fbx: is no file of motion that can be read"):
        read_raw(tmp_path / "a.fbx")
