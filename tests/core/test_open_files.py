import os

import pytest

import silpose
from silpose.core.errors import InputError
from silpose.core.open_files import check_open_files


@pytest.fixture
def few_files():
    """Leave room for eight files only."""
    resource = pytest.importorskip("resource")
    before = resource.getrlimit(resource.RLIMIT_NOFILE)
    probe = os.open(os.devnull, os.O_RDONLY)
    os.close(probe)
    resource.setrlimit(resource.RLIMIT_NOFILE, (probe + 8, before[1]))
    yield
    resource.setrlimit(resource.RLIMIT_NOFILE, before)


def test_a_run_with_room_for_few_files_does_not_begin(few_files, fast, tmp_path):
    with pytest.raises(InputError, match=r"more files can be opened, .*'ulimit -n 4096'"):
        silpose.run_experiment([*fast, f"recording.root={tmp_path}"])
    assert not list(tmp_path.iterdir())


def test_usual_limits_are_enough_and_nothing_stays_open():
    before = os.open(os.devnull, os.O_RDONLY)
    os.close(before)
    check_open_files()
    after = os.open(os.devnull, os.O_RDONLY)
    os.close(after)
    assert after == before
