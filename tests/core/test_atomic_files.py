import pytest

from silpose.core.atomic_files import writing
from silpose.core.errors import InputError


def test_a_file_has_its_name_only_once_it_is_complete(tmp_path):
    with writing(tmp_path / "a.png") as path:
        path.write_text("half")
        assert path.suffix == ".png"  # by which some writers choose the format
        assert not (tmp_path / "a.png").exists()
    assert [file.name for file in tmp_path.iterdir()] == ["a.png"]


def test_what_fails_leaves_what_was_there(tmp_path):
    (tmp_path / "a").write_text("before")
    with pytest.raises(RuntimeError), writing(tmp_path / "a") as path:
        path.write_text("half")
        raise RuntimeError
    assert [file.read_text() for file in tmp_path.iterdir()] == ["before"]


def test_a_place_that_cannot_be_written_to_is_named(tmp_path, read_only):
    for path in (tmp_path / "missing" / "a", read_only / "a"):
        refused = pytest.raises(InputError, match=f"cannot write '{path}' .*choose another place")
        with refused, writing(path):
            pass
