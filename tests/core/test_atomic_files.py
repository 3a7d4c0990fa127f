import errno

import pytest

from silpose.core.atomic_files import append_line, unfinished, writing
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


@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EFBIG, errno.EDQUOT, None])
def test_a_full_disk_is_named_and_nothing_is_left(tmp_path, number):
    error = OSError("encoder error") if number is None else OSError(number, "it is full")
    refused = pytest.raises(
        InputError, match=r"cannot write '.*a\.png' \((it is full|encoder error)"
    )
    with refused, writing(tmp_path / "a.png"):
        raise error
    assert not list(tmp_path.iterdir())


def test_what_cannot_be_read_back_gets_no_name(tmp_path):
    def check(path):
        assert path.read_text() == "whole"
        raise InputError("damaged")

    with pytest.raises(InputError, match="damaged"), writing(tmp_path / "a", check) as path:
        path.write_text("whole")
    assert not list(tmp_path.iterdir())


def test_two_processes_never_write_to_one_temporary_file(tmp_path, monkeypatch):
    with writing(tmp_path / "a.npz") as mine:
        monkeypatch.setattr("os.getpid", lambda: 1)
        with writing(tmp_path / "a.npz") as other:
            assert mine != other
            assert set(unfinished(tmp_path / "a.npz")) == {mine, other}


def test_a_line_is_appended_whole_or_not_at_all(tmp_path):
    resource = pytest.importorskip("resource")  # Windows has none
    file = tmp_path / "a.csv"
    append_line(file, "first\n")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (9, before[1]))  # half of the second line fits
    try:
        with pytest.raises(InputError, match=r"cannot write '.*a\.csv' \(.*free some space"):
            append_line(file, "second\n")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert file.read_text() == "first\n"
    append_line(file, "third\n")
    assert file.read_text() == "first\nthird\n"
