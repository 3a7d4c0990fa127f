"""What documentation shows must be true."""

import doctest
import importlib
import re
import tomllib
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
    for name in re.findall(r"^\| `(\w+)` \|", readme, flags=re.MULTILINE):
        places = [PROJECT / "silpose" / name, PROJECT / "conf" / "experiment" / f"{name}.yaml"]
        assert any(place.exists() for place in places), name
    for link in re.findall(r"\]\((?!http)([^)]+)\)", readme):
        assert (PROJECT / link).exists(), link


def test_the_readme_maps_every_package_to_its_layer():
    readme = (PROJECT / "README.md").read_text()
    documented: dict[int, set[str]] = {}
    for layer, name in re.findall(r"^\| (\d) \| `(\w+)` \|", readme, flags=re.MULTILINE):
        documented.setdefault(int(layer), set()).add(name)
    settings = tomllib.loads((PROJECT / "pyproject.toml").read_text())
    (contract,) = settings["tool"]["importlinter"]["contracts"]
    layers = [set(re.findall(r"\w+", layer)) for layer in contract["layers"]]
    assert [documented[k] for k in sorted(documented, reverse=True)] == layers
    packages = {path.parent.name for path in (PROJECT / "silpose").glob("*/__init__.py")}
    assert set().union(*layers) == packages


def test_ci_runs_the_command_that_the_readme_gives():
    command = next(
        line for line in (PROJECT / "README.md").read_text().splitlines() if "pytest" in line
    )
    assert command in (PROJECT / ".ci" / "run").read_text()
