"""What documentation shows must be true."""

import doctest
import importlib
import re
import shlex
import tomllib
from pathlib import Path

import pytest

from silpose.app.commands import TOOLS
from silpose.app.config import load
from silpose.app.verbs import EXPERIMENT_VERBS, overrides_of
from silpose.experiments import EXPERIMENTS

PROJECT = Path(__file__).parents[1]


@pytest.mark.parametrize("module", ["silpose.descriptor.histogram", "silpose.regression"])
def test_examples_in_docstrings_run(module):
    result = doctest.testmod(importlib.import_module(module))
    assert result.attempted > 0
    assert result.failed == 0


PAGES = [PROJECT / "README.md", *sorted((PROJECT / "docs").rglob("*.md"))]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_links_lead_somewhere(page):
    for link in re.findall(r"\]\((?!http)([^)#]+)", page.read_text()):
        assert (page.parent / link).exists(), link


def test_every_experiment_is_documented_and_none_that_does_not_exist():
    rows = re.findall(r"^\| (`.+?`) \|", (PROJECT / "docs" / "paper.md").read_text(), re.MULTILINE)
    documented = {name for row in rows for name in re.findall(r"`(\w+)`", row)}
    assert documented == {*EXPERIMENTS}


def commands(page):
    """Lines of a page that begin with ``silpose``, as arguments."""
    text = page.read_text().replace("\\\n", " ")
    for block in re.findall(r"```sh\n(.*?)```", text, re.DOTALL):
        for line in block.splitlines():
            if line.startswith("silpose "):
                yield shlex.split(line, comments=True)[1:]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_commands_are_understood(page):
    for arguments in commands(page):
        verb, *rest = arguments
        if verb in EXPERIMENT_VERBS:
            load(overrides_of(verb, rest))
        elif verb not in TOOLS:
            sweep = "-m" in arguments  # whose first job is looked at
            load([a.split(",")[0] if sweep else a for a in arguments if a != "-m"])


def test_the_documentation_maps_every_package_to_its_layer():
    design = (PROJECT / "docs" / "design.md").read_text()
    documented: dict[int, set[str]] = {}
    for layer, name in re.findall(r"^\| (\d) \| `(\w+)` \|", design, flags=re.MULTILINE):
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
