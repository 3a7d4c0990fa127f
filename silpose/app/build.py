"""Components from settings, each value checked against the type of its parameter."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from typing import Any

from silpose.app.registry import ALTERNATIVES, COMPONENTS, Component
from silpose.app.signatures import REQUIRED, Parameter
from silpose.app.suggestions import nearest
from silpose.core.errors import InputError
from silpose.regression import Candidates


def build(group: str, settings: Mapping[str, Any], /, **given: Any) -> Any:
    """Build the component of a group.

    Parameters
    ----------
    group : str
        Its name in the registry.
    settings : mapping
    **given
        Further arguments, which are no settings.

    Raises
    ------
    InputError
        If a setting has another type than its parameter, is missing, or there is no such one.
    """
    return prepare_call(COMPONENTS[group], group, settings, **given)()


def build_alternative(group: str, settings: Mapping[str, Any]) -> Any:
    """Build the component that a group's ``kind`` names."""
    alternatives, kind = ALTERNATIVES[group], settings.get("kind")
    if kind not in alternatives:
        raise InputError(f"there is no '{group}.kind={kind}'{nearest(str(kind), alternatives)}")
    own = {name: value for name, value in settings.items() if name != "kind"}
    return prepare_call(alternatives[kind], group, own)()


def build_candidates(group: str, settings: Mapping[str, Any]) -> Candidates[Any]:
    """Build the estimator of a group, with lists as the values to choose from."""
    component = COMPONENTS[group]
    values, grid = _checked(component, group, settings)
    with _named_in_full(component, group):
        return Candidates(component.load()(**values), grid)


def prepare_call(
    component: Component, group: str, settings: Mapping[str, Any], /, **given: Any
) -> Callable[[], Any]:
    """Check the settings of a component, and leave its call to be made."""
    values, _ = _checked(component, group, settings)
    call = partial(component.load(), **values, **given)

    def named_in_full() -> Any:
        with _named_in_full(component, group):
            return call()

    return named_in_full


@contextmanager
def _named_in_full(component: Component, group: str) -> Iterator[None]:
    """Add the group to a message that begins with the name of a parameter."""
    try:
        yield
    except InputError as error:
        if group and str(error).partition(" ")[0] in component.settings:
            raise InputError(f"{group}.{error}") from error
        raise


def _checked(
    component: Component, group: str, settings: Mapping[str, Any]
) -> tuple[dict[str, Any], dict[str, list[Any]]]:
    """Convert all settings to their types; keep apart the lists to choose from."""
    known, prefix = component.settings, f"{group}." if group else ""
    if not isinstance(settings, Mapping):
        raise InputError(
            f"'{group}' has settings of its own, such as {prefix}{next(iter(known))}=…"
        )
    values: dict[str, Any] = {}
    grid: dict[str, list[Any]] = {}
    for name, value in settings.items():
        where = f"{prefix}{name}"
        if name not in known:
            names = [f"{prefix}{other}" for other in known]
            raise InputError(f"there is no setting '{where}'{nearest(where, names)}")
        if value == REQUIRED:
            continue
        if component.candidates and known[name].type.items is None and _is_list(value):
            grid[name] = [_converted(known[name], where, item) for item in value]
            if not grid[name]:
                raise InputError(f"'{where}' must be {known[name].type.in_words()}, not []")
        else:
            values[name] = _converted(known[name], where, value)
    for name, parameter in known.items():
        if parameter.default == REQUIRED and name not in values:
            raise InputError(f"'{prefix}{name}' is not set: add {prefix}{name}=…")
    return values, grid


def _is_list(value: Any) -> bool:
    return isinstance(value, Sequence) and not isinstance(value, str)


def _converted(parameter: Parameter, where: str, value: Any) -> Any:
    try:
        return parameter.type.convert(value)
    except ValueError as error:
        words = parameter.type.in_words()
        raise InputError(f"'{where}' must be {words}, not {value!r}") from error
