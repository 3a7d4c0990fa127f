"""What a command sweeps: which settings vary, what the sweep is called, where its runs go."""

from __future__ import annotations

import hashlib
import json
import os
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from hydra.core.override_parser.types import Override
from omegaconf import DictConfig, OmegaConf

from silpose.app.config import load, plain
from silpose.app.sweep.values import first_value, parsed, values_of
from silpose.app.typed_paths import FILES, quoted
from silpose.core.errors import InputError
from silpose.recording.header import versions
from silpose.recording.runs.sweep_folder import read_definition, write_definition

_NO_MATTER = (
    "hydra", "n_jobs", "engine", "address", "debug", "dataset.cache", "recording.root",
    "recording.sweep",
)  # fmt: skip
_LONGEST_NAME = 40


@dataclass(frozen=True)
class SweepPlan:
    """A sweep that is still to be run.

    Attributes
    ----------
    name : str
    folders : tuple of Path
        Of the sweep, one for each experiment; absolute.
    overrides : tuple of str
        What Hydra is given instead of what was typed: paths are absolute.
    varied : tuple of str
        Names of the settings that vary.
    common : dict of str to str
        What all runs have in common beside the defaults, as typed.
    runs : int or None
        How many; None where a sweeper draws them.
    launcher, sweeper : DictConfig
        Hydra's settings of the two.
    """

    name: str
    folders: tuple[Path, ...]
    overrides: tuple[str, ...]
    varied: tuple[str, ...]
    common: dict[str, str]
    runs: int | None
    launcher: DictConfig
    sweeper: DictConfig

    def prepare(self) -> list[str]:
        """Make the sweep's folders, or find that they hold this very sweep.

        Returns
        -------
        doubts : list of str
            Why runs that were finished earlier may differ from those to come.

        Raises
        ------
        InputError
            If a folder holds another sweep, or cannot be written to.
        """
        definition = {"varied": list(self.varied), "common": self.common, "versions": versions()}
        doubts = []
        for folder in self.folders:
            try:
                before = read_definition(folder)
                if not before:
                    write_definition(folder, definition)
            except OSError as error:
                raise InputError(
                    f"cannot write to '{folder}' ({error.strerror}): choose another recording.root"
                ) from error
            if before and any(before.get(key) != definition[key] for key in ("varied", "common")):
                raise InputError(
                    f"'{folder}' holds another sweep, of {_in_words(before)}: choose another "
                    "recording.sweep, or leave it out"
                )
            if before and before.get("versions") != definition["versions"]:
                doubts.append(
                    f"runs in '{folder}' that are finished were made by another version of "
                    "silpose or of what it stands on, and are kept: remove them to repeat them"
                )
        return doubts


def plan_sweep(typed: Sequence[str]) -> SweepPlan:
    """Plan the sweep that overrides describe.

    Parameters
    ----------
    typed : sequence of str
        Overrides as on the command line, with paths quoted.

    Raises
    ------
    InputError
        If a setting does not exist, or the sweep gives all its runs one name.
    """
    own = {override.get_key_element(): override for override in parsed(typed)}
    first = load(_first(own), with_hydra=True)
    sweeper = first.hydra.sweeper
    params = parsed([f"{key}={value}" for key, value in (sweeper.params or {}).items()])
    everything = {o.get_key_element(): o for o in params} | own
    settings = load(_first(everything), with_hydra=True) if params else first
    if "recording.name" in everything:
        raise InputError(
            "in a sweep runs are named by what they vary: leave out recording.name; "
            "recording.sweep=NAME names the sweep"
        )
    varied = {key: o for key, o in everything.items() if o.is_sweep_override()}
    common = {
        key: o.get_value_element_as_str()
        for key, o in everything.items()
        if key not in varied and not _without_effect(key)
    }
    drawn = "optuna" in sweeper._target_
    runs = None if drawn else _count(varied)
    paths = _absolute_paths(settings, varied)
    common |= {key: path for key, path in paths.items() if key in common}
    name = settings.recording.sweep or _name(settings, varied, common, drawn)
    if Path(name).name != name or name.startswith("."):
        raise InputError(f"recording.sweep must be the name of one folder, not '{name}'")
    root = Path(paths["recording.root"])
    given = paths | {"recording.sweep": name}
    kept = [o.input_line or "" for key, o in own.items() if key not in given]
    experiments = values_of(varied["experiment"]) if "experiment" in varied else None
    return SweepPlan(
        name,
        tuple(root / each / name for each in experiments or [str(settings.experiment)]),
        (*kept, *(f"{key}={quoted(value)}" for key, value in given.items())),
        tuple(varied),
        common,
        runs,
        settings.hydra.launcher,
        sweeper,
    )


def _count(varied: dict[str, Override]) -> int:
    """Count the runs of all combinations; refuse a setting that leaves its values open."""
    runs = 1
    for override in varied.values():
        values = values_of(override)
        if values is None:
            raise InputError(
                f"'{override.input_line}' leaves open which values to run: list them, or add "
                "hydra/sweeper=optuna"
            )
        runs *= len(values)
    return runs


def _first(overrides: dict[str, Override]) -> list[str]:
    """Give a run the first value of each setting that varies."""
    found = []
    for key, override in overrides.items():
        if not override.is_sweep_override():
            found.append(override.input_line or "")
        elif (value := first_value(override)) is not None:
            found.append(f"{key}={value}")
    return found


def _without_effect(key: str) -> bool:
    """Whether a setting changes no result."""
    return key.split("/")[0] == "hydra" or any(
        key == name or key.startswith(f"{name}.") for name in _NO_MATTER
    )


def _absolute_paths(settings: DictConfig, varied: dict[str, Override]) -> dict[str, str]:
    """Write paths in full: a job may run in another folder, and on another machine."""
    found = {}
    raw = OmegaConf.to_container(settings, resolve=False)
    for name in FILES:
        value = raw
        for part in name.split("."):
            value = value.get(part) if isinstance(value, dict) else None
        text = str(value or "")
        if not text or text == "???" or name in varied:
            continue
        # Variables are read here: a job on another machine may not have them. What else is
        # interpolated may vary, and is left to the job.
        if not re.search(r"(?<!\\)\$\{(?!oc\.env:)", text):
            text = str(OmegaConf.select(settings, name))
            if "://" not in text and not text.lstrip("-").isdecimal():  # streams and cameras
                found[name] = os.path.abspath(text)
    return found


def _name(
    settings: DictConfig, varied: dict[str, Override], common: dict[str, str], drawn: bool
) -> str:
    """Name a sweep, so that the same command finds it again, and no other one does."""
    lines = sorted(override.input_line or "" for override in varied.values())
    code = hashlib.sha256(json.dumps([lines, common, drawn], sort_keys=True).encode()).hexdigest()
    chosen = plain(settings)["hydra"]["runtime"]["choices"].get("sweep")
    words = chosen or "-".join(re.split(r"[./]", key)[-1] for key in varied) or "runs"
    return f"{words[:_LONGEST_NAME]}-{code[:6]}"


def _in_words(definition: dict[str, object]) -> str:
    common = definition.get("common")
    pairs = [f"{k}={v}" for k, v in common.items()] if isinstance(common, dict) else []
    varied = definition.get("varied")
    names = varied if isinstance(varied, list) else []
    return f"{' and '.join(map(str, names)) or 'one run'} with {' '.join(pairs) or 'the defaults'}"
