"""What ``silpose settings`` prints: every setting with its value, type and description."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import yaml
from rich.markup import escape
from rich.table import Table

from silpose.app.conf_folder import groups
from silpose.app.config import choices, load, plain
from silpose.app.registry import ALTERNATIVES, COMPONENTS, Component, experiment
from silpose.app.signatures import REQUIRED
from silpose.app.suggestions import nearest
from silpose.app.terminal import Terminal, wrapped
from silpose.core.errors import InputError

_EXPERIMENT = "experiment"
_NARROW, _NARROWEST = 100, 60  # characters of a line below which columns split words
_INDENT = "    "

Row = tuple[str, str, str, str]
"""Name of a setting, its value, type and description."""


def print_settings(wanted: Sequence[str] = (), overrides: Sequence[str] = ()) -> None:
    """Print the settings of groups, or without any the groups and their choices.

    Parameters
    ----------
    wanted : sequence of str, default=()
        Groups, or parts of them such as ``"regression.rvm"``.
    overrides : sequence of str, default=()
        Such as ``"motion=bvh"``, for the values and the choices.
    """
    given = plain(load(overrides))
    console = Terminal()
    if not wanted:
        narrow = console.width < _NARROWEST
        shown = _group_list(overrides, console.width) if narrow else _group_table(overrides)
        console.print(shown, highlight=not narrow)
    chosen, narrow = False, console.width < _NARROW
    for group in wanted or [""]:
        for title, rows in tables(group.replace("/", "."), given).items():
            shown = _list(title, rows, console.width) if narrow else _table(title, rows)
            console.print(shown, highlight=not narrow)
            chosen |= title in COMPONENTS and COMPONENTS[title].candidates
    if chosen:
        console.print("[dim]A list in place of a single value: validation chooses from it.[/dim]")


def tables(group: str, given: Mapping[str, Any]) -> dict[str, list[Row]]:
    """List the settings of a group and of its parts, each by its own.

    Parameters
    ----------
    group : str
        The empty name is that of the settings without a group.
    given : mapping
        All settings, resolved.

    Returns
    -------
    tables : dict of str to list of Row
        By the full name of the group or part.
    """
    components = dict(_components(given))
    own = [name for name in components if name == group or (group and _is_part(name, group))]
    if not own:
        raise InputError(f"there is no group '{group}'{nearest(group, filter(None, components))}")
    found = {}
    for name in own:
        values: Any = given
        for key in name.split(".") if name not in ("", _EXPERIMENT) else ():
            values = values.get(key, {})
        words = components[name].descriptions
        found[name] = [
            (key, _shown(values.get(key, p.default)), p.type.in_words(), _plain_text(words[key]))
            for key, p in components[name].settings.items()
        ]
    return found


def _components(given: Mapping[str, Any]) -> Iterator[tuple[str, Component]]:
    """List all components that the settings choose, by the group they are in."""
    yield _EXPERIMENT, experiment(given[_EXPERIMENT])
    for group, alternatives in ALTERNATIVES.items():
        if (kind := given[group].get("kind")) in alternatives:
            yield group, alternatives[kind]
    yield from COMPONENTS.items()


def _is_part(name: str, group: str) -> bool:
    return name.startswith(f"{group}.")


def _title(group: str) -> str:
    return "" if group in ("", _EXPERIMENT) else f"[bold]{group}[/bold]"


def _list(group: str, rows: Sequence[Row], width: int) -> str:
    """List settings one below another, each with its description under it."""
    lines = [_title(group)] if _title(group) else []
    for name, value, kind, description in rows:
        lines.append(escape(wrapped(f"{name} = {value}  ({kind})", width, _INDENT)))
        lines.append(escape(wrapped(_INDENT + description, width, _INDENT)))
    return "\n".join([*lines, ""])


def _table(group: str, rows: Sequence[Row]) -> Table:
    title = _title(group)
    table = Table(title=title, title_justify="left", title_style="", box=None, pad_edge=False)
    table.add_column("setting", no_wrap=True)
    table.add_column("value", overflow="fold", max_width=28)
    table.add_column("type", overflow="fold", max_width=20)
    table.add_column("description", overflow="fold", ratio=1)
    for row in rows:
        table.add_row(*map(escape, row))
    table.add_row()
    return table


def _plain_text(description: str) -> str:
    return re.sub(r"`| \[\d+\]_", "", description)  # no markup in the terminal


def _shown(value: Any) -> str:
    if value == REQUIRED:
        return "(must be given)"
    text: str = yaml.safe_dump(value, default_flow_style=True, allow_unicode=True, width=1000)
    return text.removesuffix("\n").removesuffix("\n...")


def _group_list(overrides: Sequence[str], width: int) -> str:
    """List groups one below another, each with its other choices under it."""
    lines = []
    for group, choice, others in _choices(overrides):
        lines.append(wrapped(f"{group} = {choice}", width, _INDENT))
        lines += [wrapped(f"{_INDENT}others: {others}", width, _INDENT)] if others else []
    return escape("\n".join([*lines, ""]))


def _group_table(overrides: Sequence[str]) -> Table:
    table = Table(box=None, pad_edge=False)
    for title in ("group", "choice", "others"):
        table.add_column(title, overflow="fold")
    for row in _choices(overrides):
        table.add_row(*row)
    table.add_row()
    return table


def _choices(overrides: Sequence[str]) -> Iterator[Sequence[str]]:
    """Each group, what is chosen of it, and what else there is."""
    chosen = choices(overrides)
    for group, names in groups().items():
        yield group, chosen[group], ", ".join(name for name in names if name != chosen[group])
