import importlib
import subprocess
import sys

import pytest

PACKAGES = (
    "silpose.recording",
    "silpose.recording.layout",
    "silpose.recording.runs",
    "silpose.recording.viewer",
)


@pytest.mark.parametrize("package", PACKAGES)
def test_every_public_name_is_there(package):
    module = importlib.import_module(package)
    assert module.__all__ == sorted(module.__all__)
    for name in module.__all__:
        value = getattr(module, name)
        assert not isinstance(value, type(sys)), f"{name} is a module"


def test_an_unknown_name_is_no_attribute():
    module = importlib.import_module("silpose.recording")
    with pytest.raises(AttributeError, match="no attribute 'record_nothing'"):
        module.record_nothing  # noqa: B018


def test_importing_loads_neither_rerun_nor_the_rest_of_the_library():
    code = """
import sys
import silpose.recording
loaded = {name.partition(".")[0] for name in sys.modules}
assert not loaded & {"rerun", "matplotlib", "cv2", "numpy", "hydra"}, loaded
from silpose.recording import RunFolder, load_run, record_tracking, runs_table, write_result
from silpose.recording.viewer import serving, wait
assert "rerun" not in sys.modules and "matplotlib" not in sys.modules
"""
    subprocess.run([sys.executable, "-c", code], check=True)
