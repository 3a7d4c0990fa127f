from synthetic import motion

from silpose.motion import MotionFolder, MotionSource, WalkerTakes


class Counting(MotionSource):
    """Counts how often it is read."""

    name = "counting"

    def __init__(self):
        self.count = 0

    def read(self):
        self.count += 1
        return [motion(f"take_{self.count}", 3)]


def test_takes_are_read_once():
    source = Counting()
    assert [take.name for take in source.takes()] == ["take_1"]
    assert [take.name for take in source.takes()] == ["take_1"]
    assert [take.name for take in source.read()] == ["take_2"]


def test_only_motion_capture_has_files(tmp_path, small_bvh):
    file = small_bvh().write(tmp_path / "walk.bvh")
    assert MotionFolder(tmp_path).files() == [file]
    assert WalkerTakes().files() == []
