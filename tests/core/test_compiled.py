import subprocess
import sys

import pytest

from silpose.core import compiled
from silpose.core.compiled import imported_code

MODULES = {
    "room/kernel.py": "from silpose.room.other import helper\nimport silpose.core.types\n",
    "room/other.py": "from silpose.core.skeleton import JOINTS\nfrom silpose.view import View\n",
    "core/skeleton/__init__.py": "from silpose.core.skeleton.joints import JOINTS\n",
    "core/skeleton/joints.py": "JOINTS = ()\n",
    "core/types.py": "Array = list\n",
    "view/__init__.py": "from silpose.view.view import View\n",
    "view/view.py": "View = list\n",
    "room/beside.py": "from silpose.room.kernel import kernel\n",
}


@pytest.fixture
def package(tmp_path, monkeypatch):
    for name, source in MODULES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(source)
    monkeypatch.setattr(compiled, "_PACKAGE", tmp_path)
    yield tmp_path
    compiled._read.cache_clear()


@pytest.mark.parametrize("changed", MODULES)
def test_what_a_module_imports_is_part_of_its_code(package, changed):
    kernel = package / "room/kernel.py"
    before = imported_code(kernel)
    assert imported_code(kernel) == before
    (package / changed).write_text(MODULES[changed] + "more = 1\n")
    compiled._read.cache_clear()
    assert (imported_code(kernel) == before) == changed.startswith(("view/", "room/beside"))


def test_modules_that_import_each_other_come_to_an_end(package):
    (package / "core/types.py").write_text("from silpose.room.kernel import kernel\n")
    assert len(imported_code(package / "room/kernel.py")) == 8


PROGRAM = """
import sys
from pathlib import Path
from silpose.core import compiled
compiled._PACKAGE = Path("silpose")
sys.modules["silpose"].__path__.append("silpose")
from silpose.room.kernel import kernel
print(kernel(2.0))
"""


def test_a_function_that_is_compiled_in_is_compiled_anew(tmp_path):
    room = tmp_path / "silpose" / "room"
    room.mkdir(parents=True)
    begin = "from silpose.core.compiled import compiled\n"
    (room / "kernel.py").write_text(
        begin + "from silpose.room.other import other\n\n"
        "@compiled()\ndef kernel(x):\n    return other(x)\n"
    )
    found = []
    for factor in (3, 3, 5):
        source = f"{begin}\n@compiled()\ndef other(x):\n    return {factor} * x\n"
        (room / "other.py").write_text(source)
        done = subprocess.run(
            [sys.executable, "-c", PROGRAM],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=True,
        )
        found.append(float(done.stdout))
    assert found == [6.0, 6.0, 10.0]
    kept = list((room / "__pycache__").glob("kernel.*.nbi"))
    assert len(kept) == 2  # the second time it was found
