"""Values that overrides give to settings: one, or those of a sweep."""

from __future__ import annotations

from collections.abc import Sequence
from fnmatch import fnmatchcase

from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.override_parser.types import Glob, Override
from hydra.errors import HydraException

from silpose.app.conf_folder import groups
from silpose.app.config import explain
from silpose.core.errors import InputError


def parsed(overrides: Sequence[str]) -> list[Override]:
    """Read overrides by Hydra's grammar.

    Raises
    ------
    InputError
        If one cannot be read.
    """
    try:
        return OverridesParser.create().parse_overrides(list(overrides))
    except HydraException as error:
        raise InputError(explain(error, overrides)) from error


def values_of(override: Override) -> list[str] | None:
    """List the values of a sweep as typed; None where there is an interval of them.

    Raises
    ------
    InputError
        If there are none.
    """
    value = override.value()
    if override.is_interval_sweep():
        return None
    if isinstance(value, Glob):
        known = groups().get(override.get_key_element(), ())
        values = [
            name
            for name in known
            if any(fnmatchcase(name, pattern) for pattern in value.include)
            and not any(fnmatchcase(name, pattern) for pattern in value.exclude)
        ]
    else:
        values = list(override.sweep_string_iterator())
    if not values:
        raise InputError(f"'{override.input_line}' has no values to run")
    return values


def first_value(override: Override) -> str | None:
    """Return the first value of a sweep; None where there is an interval of them."""
    values = values_of(override)
    return None if values is None else values[0]
