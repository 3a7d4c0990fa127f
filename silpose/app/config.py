"""Settings composed by Hydra from ``conf/`` and overrides, and what is wrong with the latter."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from hydra import compose, initialize_config_dir
from hydra.core.global_hydra import GlobalHydra
from hydra.errors import HydraException, MissingConfigException
from omegaconf import DictConfig, OmegaConf
from omegaconf.errors import OmegaConfBaseException

from silpose.app.conf_folder import config_folder, groups
from silpose.app.schema import register
from silpose.app.suggestions import nearest
from silpose.app.typed_paths import with_paths_quoted
from silpose.core.errors import InputError


def load(overrides: Sequence[str] = ()) -> DictConfig:
    """Compose the settings, as the command line does.

    Parameters
    ----------
    overrides : sequence of str, default=()
        Such as ``"motion=bvh"`` or ``"regression.rvm.nu=3"``.

    Returns
    -------
    settings : DictConfig

    Raises
    ------
    InputError
        If there is no such choice or setting; it names the nearest.
    """
    overrides = with_paths_quoted(overrides)
    try:
        settings = _compose(overrides)
    except HydraException as error:
        raise InputError(explain(error, overrides)) from error
    check_overrides(settings, overrides)
    return settings


def choices(overrides: Sequence[str] = ()) -> dict[str, str]:
    """Name the choice of every group that some overrides lead to."""
    chosen = _compose(overrides, with_hydra=True).hydra.runtime.choices
    return {group: str(chosen[group]) for group in groups()}


def _compose(overrides: Sequence[str], with_hydra: bool = False) -> DictConfig:
    register()
    hydra = GlobalHydra.instance()
    running, hydra.hydra = hydra.hydra, None
    try:
        with initialize_config_dir(str(config_folder()), version_base="1.3", job_name="silpose"):
            return compose("config", overrides=list(overrides), return_hydra_config=with_hydra)
    finally:
        hydra.hydra = running  # of the job that this may be called in


def explain(error: HydraException, overrides: Sequence[str] = ()) -> str:
    """Say in one sentence what Hydra found wrong with the overrides."""
    message = str(error).strip()
    if isinstance(error, MissingConfigException) and error.options:
        group, _, choice = str(error.missing_cfg_file).rpartition("/")
        return f"there is no {group}={choice}{nearest(choice, error.options)}"
    if key := re.match(r"(?:Could not override|Error merging override) '?([\w.]+)", message):
        known = list(names(_chosen(overrides)))
        if key[1] not in known:
            return f"there is no setting '{key[1]}'{nearest(key[1], known)}"
    if key := re.match(r"Could not append to config. An item is already at '(.*)'", message):
        return f"'{key[1]}' is a setting: write {key[1]}=… without '+'"
    if key := re.match(r"Multiple values for ([\w/]+)", message):
        return f"{key[1]} is chosen twice: write {key[1]}=… once, without '+'"
    if key := re.match(r"Error parsing override '(.*)'", message):
        return f"cannot read '{key[1]}': settings are given as key=value"
    return message.splitlines()[0]


def _chosen(overrides: Sequence[str]) -> DictConfig:
    """Compose what the overrides choose among the groups' files, without their other settings."""
    chosen = []
    for override in overrides:
        group, _, choice = override.partition("=")
        if group in groups():
            chosen.append(f"{group}={choice.split(',')[0]}")  # of a sweep the first
    try:
        return _compose(chosen)
    except HydraException:
        return _compose([])


def check_overrides(settings: DictConfig, overrides: Sequence[str]) -> None:
    """Refuse overrides that Hydra lets pass, but that nothing would read: additions, deletions."""
    for override in overrides:
        name = override.lstrip("+~").split("=")[0]
        if override == name or name == override.split("=")[0] or name.startswith("hydra."):
            continue
        known = [n for n in names(_chosen(overrides))]
        if name not in known:
            raise InputError(f"there is no setting '{name}'{nearest(name, known)}")
        if override.startswith("~"):
            raise InputError(f"'{name}' cannot be deleted: leave out '{override}'")


def names(settings: DictConfig) -> Iterator[str]:
    """List the full names of all settings and of the groups that hold them."""
    return _names(OmegaConf.to_container(settings))


def _names(tree: Any, prefix: str = "") -> Iterator[str]:
    if isinstance(tree, Mapping):
        for key, value in tree.items():
            yield f"{prefix}{key}"
            yield from _names(value, f"{prefix}{key}.")


def plain(settings: DictConfig) -> dict[str, Any]:
    """Resolve all settings to values, lists and dictionaries of them."""
    try:
        resolved = OmegaConf.to_container(settings, resolve=True)
    except OmegaConfBaseException as error:
        raise InputError(f"cannot read the settings: {str(error).splitlines()[0]}") from error
    assert isinstance(resolved, dict)
    return {str(name): value for name, value in resolved.items()}
