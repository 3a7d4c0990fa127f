import os

from silpose.core.digest import digest


def test_settings_and_files_make_the_name(tmp_path):
    file = tmp_path / "walk.bvh"
    file.write_text("one")
    named = digest({"a": 1, "b": [2]}, [file])
    assert len(named) == 20 and named == digest({"b": [2], "a": 1}, [file])
    assert named != digest({"a": 1, "b": [3]}, [file])
    os.utime(file, (1, 1))
    assert named != digest({"a": 1, "b": [2]}, [file])
