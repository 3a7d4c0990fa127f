import os
import shutil

import pytest

from silpose.core.errors import InputError
from silpose.recording import find_runs, newest_run


def test_runs_are_found_the_latest_first(finished, tmp_path):
    for k, name in enumerate(("deep/er/001", "002", "003")):
        shutil.copytree(finished.folder, tmp_path / name)
        os.utime(tmp_path / name / "metrics.json", (k, k))
    (tmp_path / "003" / "metrics.json").write_text("{}")
    found, others = find_runs(tmp_path)
    assert [run.folder.name for run in found] == ["002", "001"]
    assert others == [tmp_path / "003"]
    assert newest_run(tmp_path).folder == tmp_path / "002"


def test_without_runs_there_is_no_newest(tmp_path):
    with pytest.raises(InputError, match="no finished runs below"):
        newest_run(tmp_path)
    with pytest.raises(InputError, match="there is no folder"):
        find_runs(tmp_path / "nowhere")
