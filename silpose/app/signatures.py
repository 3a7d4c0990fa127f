"""Parameters of constructors, read from their source without importing it.

The imports would take seconds, which ``--help`` and a misspelt setting cannot wait for.
"""

from __future__ import annotations

from ast import literal_eval
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import griffe
from griffe import (
    Attribute,
    Class,
    DocstringSectionKind,
    Expr,
    ExprAttribute,
    ExprBinOp,
    ExprName,
    ExprSubscript,
    ExprTuple,
    Function,
    Module,
    Object,
)

from silpose.app.setting_types import SettingType

_SOURCE = Path(__file__).parents[2]  # the folder that holds the package
_SCALARS = {"int": int, "float": float, "str": str, "bool": bool}
_SEQUENCES = {"collections.abc.Sequence", "list", "tuple"}
_MAPPINGS = {"collections.abc.Mapping", "dict"}
_NOTHING = SettingType()

REQUIRED = "???"
"""Stands, as in Hydra, where a value must be given."""


@dataclass(frozen=True)
class Parameter:
    """One parameter of a constructor that settings can give.

    Attributes
    ----------
    name : str
    type : SettingType
    default : object
        `REQUIRED` if there is none; sequences are lists, as in YAML.
    """

    name: str
    type: SettingType
    default: Any


@cache
def parameters(path: str) -> dict[str, Parameter]:
    """Read the parameters of a class or function whose types are plain.

    Parameters
    ----------
    path : str
        Such as ``"silpose.regression:Basis"``; the package may have imported it from elsewhere.

    Returns
    -------
    parameters : dict of str to Parameter
        By name, in order.
    """
    found = {}
    for name, annotation, default in _signature(_find(path.replace(":", "."))):
        kind = _type(annotation)
        if kind.can_be_set:
            value = REQUIRED if default is None else _value(default)
            found[name] = Parameter(name, kind, value)
    return found


@cache
def descriptions(path: str) -> dict[str, str]:
    """Read what the docstring of a class or function says of each parameter.

    Apart from `parameters`, as parsing docstrings takes half of the time.
    """
    target = _find(path.replace(":", "."))
    kinds = (DocstringSectionKind.parameters, DocstringSectionKind.attributes)
    return {
        name: " ".join(item.description.split())
        for section in (target.docstring.parsed if target.docstring else ())
        if section.kind in kinds
        for item in section.value
        for name in item.name.split(", ")
    }


@cache
def _module(name: str) -> Module | None:
    stem = _SOURCE.joinpath(*name.split("."))
    for file in (stem.with_suffix(".py"), stem / "__init__.py"):
        if file.is_file():
            code = file.read_text(encoding="utf-8")
            return griffe.visit(
                name,
                file,
                code,
                docstring_parser="numpy",
                docstring_options={"warnings": False},
            )
    return None


def _find(path: str) -> Object:
    """Find a class, function or constant of the package by its dotted path."""
    names = path.split(".")
    for k in range(len(names) - 1, 0, -1):
        found: Any = _module(".".join(names[:k]))
        if found is None:
            continue
        for position, name in enumerate(names[k:], start=k + 1):
            found = found.members[name]
            if found.is_alias:  # imported: go where it is from
                return _find(".".join([found.target_path, *names[position:]]))
        return found  # type: ignore[no-any-return]
    raise LookupError(f"{path} is no name of the package")


def _signature(target: Object) -> list[tuple[str, Any, Any]]:
    """List names, annotations and defaults, the latter None where there is none."""
    if isinstance(target, Class):
        if "__init__" in target.members:
            target = target.members["__init__"]  # type: ignore[assignment]
        elif any("dataclass" in str(decorator.value) for decorator in target.decorators):
            return [
                (name, member.annotation, member.value)
                for name, member in target.members.items()
                if isinstance(member, Attribute) and "property" not in member.labels
            ]
        else:
            return _signature(_base(target))
    assert isinstance(target, Function)
    return [
        (p.name, p.annotation, p.default)
        for p in target.parameters
        if p.annotation is not None and p.name not in ("self", "cls")
    ]


def _base(target: Class) -> Object:
    for base in target.bases:
        if isinstance(base, Expr) and base.canonical_path.startswith("silpose."):
            return _find(base.canonical_path)
    raise LookupError(f"{target.path} has no constructor")


def _type(annotation: Any) -> SettingType:
    """Reduce an annotation to its plain types."""
    if isinstance(annotation, ExprBinOp):
        return _type(annotation.left) | _type(annotation.right)
    if isinstance(annotation, ExprSubscript):
        return _generic(annotation)
    if isinstance(annotation, ExprName | ExprAttribute):
        path = annotation.canonical_path
        if path in _SCALARS:
            return SettingType((_SCALARS[path],))
        if path in _MAPPINGS:
            return SettingType(mapping=True)
        if path.startswith("silpose."):  # perhaps a name for a plain type
            named = _find(path)
            if isinstance(named, Attribute):
                return _type(named.value)
    return SettingType(optional=True) if annotation == "None" else _NOTHING


def _generic(annotation: ExprSubscript) -> SettingType:
    left = getattr(annotation.left, "canonical_path", "")
    inside = annotation.slice
    items = list(inside.elements) if isinstance(inside, ExprTuple) else [inside]
    if left == "typing.Literal":
        return SettingType(choices=tuple(literal_eval(str(item)) for item in items))
    if left in _MAPPINGS:
        return SettingType(mapping=True)
    if left in _SEQUENCES:
        item = _type(items[0])
        return SettingType(items=item) if item.can_be_set else _NOTHING
    return _NOTHING


def _value(default: Any) -> Any:
    """Evaluate a default: a literal, or the name of a constant of the package."""
    if isinstance(default, ExprName | ExprAttribute):
        constant = _find(default.canonical_path)
        assert isinstance(constant, Attribute)
        return _value(constant.value)
    value = literal_eval(str(default))
    return list(value) if isinstance(value, tuple) else value
