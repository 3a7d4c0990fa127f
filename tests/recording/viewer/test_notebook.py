import sys

import pytest

from silpose.core.errors import InputError
from silpose.recording import show


def test_a_missing_recording_is_named(tmp_path):
    with pytest.raises(InputError, match=r"there is no recording '.*no\.rrd'"):
        show(tmp_path / "no.rrd")


def test_without_its_package_a_remedy_is_named(finished, monkeypatch):
    monkeypatch.setitem(sys.modules, "rerun_notebook", None)
    with pytest.raises(InputError, match=r"pip install 'silpose\[notebook\]'"):
        show(finished.recording)
