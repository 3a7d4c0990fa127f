"""What documentation shows must be true."""

import doctest
import importlib
import re
from pathlib import Path

import pytest

PROJECT = Path(__file__).parents[1]


@pytest.mark.parametrize("module", ["silpose.descriptor.histogram", "silpose.regression"])
def test_examples_in_docstrings_run(module):
    result = doctest.testmod(importlib.import_module(module))
    assert result.attempted > 0
    assert result.failed == 0


def test_the_readme_names_what_exists():
    readme = (PROJECT / "README.md").read_text()
    for room in re.findall(r"^\| `(\w+)` \|", readme, flags=re.MULTILINE):
        places = [PROJECT / "silpose" / room, PROJECT / "conf" / "experiment" / f"{room}.yaml"]
        assert any(place.exists() for place in places), room
    for link in re.findall(r"\]\((?!http)([^)]+)\)", readme):
        assert (PROJECT / link).exists(), link


def test_ci_runs_the_command_that_the_readme_gives():
    command = next(
        line for line in (PROJECT / "README.md").read_text().splitlines() if "pytest" in line
    )
    assert command in (PROJECT / ".ci" / "run").read_text()
