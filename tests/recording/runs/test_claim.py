import subprocess
import sys

import pytest

from silpose.core.errors import InputError
from silpose.recording.runs.claim import claimed

pytest.importorskip("fcntl")
CLAIM = """
import sys; from pathlib import Path; from silpose.recording.runs.claim import claimed
with claimed(Path(sys.argv[1])):
    print("claimed", flush=True); sys.stdin.read()
"""


def test_a_killed_process_frees_its_folder(tmp_path):
    command = [sys.executable, "-c", CLAIM, str(tmp_path)]
    other = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    assert other.stdout.readline() == b"claimed\n"
    with pytest.raises(InputError, match="another run is working"), claimed(tmp_path):
        pass
    other.kill()
    other.wait()
    with claimed(tmp_path):
        assert not list(tmp_path.iterdir())
