import subprocess
import sys
from pathlib import Path

import pytest
from rerun.chunk import RrdReader

from silpose.core.errors import InputError
from silpose.recording import entity_paths as entities
from silpose.recording import repair, runs_table


@pytest.fixture
def cut_off(finished, tmp_path):
    """A run killed when nine tenths of its recording were written."""
    folder = tmp_path / "single_image" / "killed"
    folder.mkdir(parents=True)
    whole = finished.recording.read_bytes()
    (folder / ".run.partial.rrd").write_bytes(whole[: int(0.9 * len(whole))])
    return folder


def test_what_was_written_is_salvaged(cut_off):
    salvaged = repair(cut_off)
    rerun = Path(sys.executable).with_name("rerun")
    assert subprocess.run([rerun, "rrd", "verify", salvaged], capture_output=True).returncode == 0
    assert entities.MASK in {chunk.entity_path for chunk in RrdReader(salvaged).stream()}
    assert not runs_table(cut_off.parents[1]).loc[("single_image", "killed"), "complete"]


def test_a_folder_that_cannot_be_written_to_is_named(finished, read_only):
    (read_only / "run.rrd").write_bytes(finished.recording.read_bytes())
    with pytest.raises(InputError, match=r"cannot write '.*salvaged\.rrd'"):
        repair(read_only)


def test_what_cannot_be_salvaged_is_named(tmp_path):
    with pytest.raises(InputError, match="holds no recording"):
        repair(tmp_path)
    with pytest.raises(InputError, match="there is no recording"):
        repair(tmp_path / "no.rrd")
    (tmp_path / "run.rrd").write_bytes(b"nonsense")
    with pytest.raises(InputError, match="run the experiment again"):
        repair(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["run.rrd"]
