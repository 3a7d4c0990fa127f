import subprocess
import sys

import pytest


@pytest.mark.parametrize("command", ["list", "settings"])
def test_a_reader_that_has_read_enough_is_no_error(command, tmp_path):
    """As of `head -1`, which closes the pipe after a line."""
    run = subprocess.Popen(
        [sys.executable, "-m", "silpose", command],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        cwd=tmp_path,
    )
    run.stdout.close()
    assert run.stderr.read() == b""
    assert run.wait() == 0


def test_nor_of_what_a_run_prints(mask_folder, tmp_path):
    run = subprocess.Popen(
        [sys.executable, "-m", "silpose", "masks", str(mask_folder), "recording=none"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        cwd=tmp_path,
    )
    run.stdout.close()
    assert b"silpose:" not in run.stderr.read()
    assert run.wait() == 0
