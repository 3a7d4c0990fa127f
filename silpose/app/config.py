"""Settings composed by Hydra from ``conf/`` and overrides, and what is wrong with the latter."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import Any

from hydra import compose, initialize_config_dir
from hydra.core.global_hydra import GlobalHydra
from hydra.errors import HydraException, MissingConfigException, OverrideParseException
from omegaconf import DictConfig, OmegaConf
from omegaconf.errors import OmegaConfBaseException

from silpose.app.conf_folder import config_folder, groups
from silpose.app.schema import register
from silpose.app.suggestions import nearest
from silpose.app.typed_paths import with_paths_quoted
from silpose.core.errors import InputError


def load(overrides: Sequence[str] = (), *, with_hydra: bool = False) -> DictConfig:
    """Compose the settings, as the command line does.

    Parameters
    ----------
    overrides : sequence of str, default=()
        Such as ``"motion=bvh"`` or ``"regression.rvm.nu=3"``.
    with_hydra : bool, default=False
        Whether Hydra's own settings are among them, as ``hydra``.

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
        settings = _compose(overrides, with_hydra)
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
    if key := re.match(
        r"(?:Could not override|Error merging override) '?([\w./]+)(?:=(.*))?", message
    ):
        if not _exists(key[1], _chosen(overrides)):
            return _no_such_setting(key[1], overrides)
        if key[1] in groups():
            return f"'{key[1]}' takes one name: {', '.join(groups()[key[1]])}"
        return f"'{key[1]}' cannot be {key[2]}: 'silpose settings' shows its type"
    if key := re.match(r"Could not append to config. An item is already at '(.*)'", message):
        return f"'{key[1]}' is a setting: write {key[1]}=… without '+'"
    if key := re.match(r"Multiple values for ([\w/]+)", message):
        return f"{key[1]} is chosen twice: write {key[1]}=… once, without '+'"
    if several := re.match(r"Ambiguous value for argument '(.*)'", message):
        return f"'{several[1]}' is more than one run: silpose -m {several[1]} makes each of them"
    if isinstance(error, OverrideParseException):
        return _unreadable(error.override)
    return message.splitlines()[0]


def _unreadable(override: str) -> str:
    """Say what may be wrong with an override that Hydra cannot read."""
    key, _, value = override.partition("=")
    if not re.fullmatch(r"[\w@./+~-]+", key) or key == override:
        return f"cannot read '{override}': settings are given as key=value"
    if "/" in key and "." in key:
        return f"cannot read '{override}': write {key.replace('/', '.')}={value}"
    if any(value.count(a) != value.count(b) for a, b in ("[]", "{}", "()")):
        return f"cannot read '{override}': not every bracket is closed"
    example = '{left_elbow: ["#1"]}' if value.startswith("{") else '"a=b"'
    return (
        f"cannot read '{override}': put text with special characters in double quotes within the "
        f"single ones, such as '{key}={example}'"
    )


def _no_such_setting(key: str, overrides: Sequence[str]) -> str:
    """Name the choices that have a setting that does not exist, else its neighbours."""
    made = _choices_among(overrides)
    for group, own in groups().items():
        if not key.startswith(f"{group.replace('/', '.')}."):
            continue
        having = [name for name in own if _exists(key, _chosen([*made, f"{group}={name}"]))]
        if having:
            words = " and ".join(f"{group}={name}" for name in having)
            if any(choice.startswith(f"{group}=") for choice in made):
                return f"'{key}' is a setting of {words}, not of {group}={choices(made)[group]}"
            return f"'{key}' is a setting of {words}: add {group}={having[-1]}"
    return f"there is no setting '{key}'{nearest(key, names(_chosen(overrides)))}"


def _exists(name: str, settings: DictConfig) -> bool:
    """Whether a setting exists, or may be added to one that is a mapping with free keys."""
    if name in names(settings):
        return True
    above, _, _ = name.rpartition(".")
    while above:
        node = OmegaConf.select(settings, above)
        if isinstance(node, DictConfig):
            return not OmegaConf.is_struct(node)
        above, _, _ = above.rpartition(".")
    return False


def _chosen(overrides: Sequence[str]) -> DictConfig:
    """Compose what the overrides choose among the groups' files, without their other settings."""
    return _composed(tuple(_choices_among(overrides)))


@cache
def _composed(made: tuple[str, ...]) -> DictConfig:
    try:
        return _compose(made)
    except HydraException:
        return _compose([])


def _choices_among(overrides: Sequence[str]) -> list[str]:
    """Those overrides that choose a group's file, the last of each group, of a sweep the first."""
    made: dict[str, str] = {}
    for override in overrides:
        group, _, choice = override.lstrip("+").partition("=")
        if group in groups():
            made[group] = choice.split(",")[0].strip("'\" ")
    return [f"{group}={choice}" for group, choice in made.items()]


def check_overrides(settings: DictConfig, overrides: Sequence[str]) -> None:
    """Refuse overrides that Hydra lets pass, but that nothing would read: additions, deletions."""
    for override in overrides:
        name = override.lstrip("+~").split("=")[0]
        if override == name or name == override.split("=")[0] or name.startswith("hydra."):
            continue
        if not _exists(name, _chosen(overrides)):
            raise InputError(_no_such_setting(name, overrides))
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
