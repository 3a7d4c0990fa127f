"""Types that settings may have, and the check of a value against one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

_WORDS = {int: "an integer", float: "a number", str: "text", bool: "true or false"}
_PLURALS = {int: "integers", float: "numbers", str: "texts", bool: "true and false"}


@dataclass(frozen=True)
class SettingType:
    """Union of the plain types that an annotation names.

    Attributes
    ----------
    scalars : tuple of type
        Any of int, float, str and bool.
    choices : tuple
        The only values, of ``Literal``.
    items : SettingType or None
        Type of the items, if the value may be a sequence.
    mapping : bool
        Whether the value may be a mapping, of anything.
    optional : bool
        Whether the value may be None.
    """

    scalars: tuple[type, ...] = ()
    choices: tuple[Any, ...] = ()
    items: SettingType | None = None
    mapping: bool = False
    optional: bool = False

    def __or__(self, other: SettingType) -> SettingType:
        """Allow the values of either."""
        return SettingType(
            tuple(dict.fromkeys(self.scalars + other.scalars)),
            tuple(dict.fromkeys(self.choices + other.choices)),
            self.items or other.items,
            self.mapping or other.mapping,
            self.optional or other.optional,
        )

    @property
    def can_be_set(self) -> bool:
        """Whether more values than None are plain."""
        return bool(self.scalars or self.choices or self.items or self.mapping)

    def convert(self, value: Any) -> Any:
        """Convert a value that was read from YAML or the command line.

        Raises
        ------
        ValueError
            If the value has no such type.
        """
        if (value is None and self.optional) or value in self.choices:
            return value
        if isinstance(value, Mapping):
            if self.mapping:
                return dict(value)
        elif isinstance(value, Sequence) and not isinstance(value, str):
            if self.items is not None:
                return [self.items.convert(item) for item in value]
        elif not self.choices or self.scalars:
            return self._convert_scalar(value)
        raise ValueError(value)

    def _convert_scalar(self, value: Any) -> Any:
        if isinstance(value, bool):
            kinds: tuple[type, ...] = (bool,)
        elif isinstance(value, int):
            kinds = (int, float, str)
        elif isinstance(value, float):
            kinds = (float, str)
        else:
            kinds = (type(value),)
        for kind in kinds:
            if kind in self.scalars:
                return kind(value)
        raise ValueError(value)

    def in_words(self) -> str:
        """Describe the values, to follow "must be"."""
        words = [_WORDS[kind] for kind in self.scalars]
        if self.choices:
            listed = ", ".join(map(str, self.choices))
            words.append(listed if len(self.choices) == 1 else f"one of {listed}")
        if self.items is not None:
            kinds = [_PLURALS[kind] for kind in self.items.scalars] or list(self.items.choices)
            words.append(f"a list of {' or '.join(kinds) or 'lists'}")
        if self.mapping:
            words.append("a mapping like {name: value}")
        return " or ".join(words + ["null"] * self.optional)
