"""`MaskFacts`: what is in each mask, besides the person's pose."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Array, Indices

Flags = NDArray[np.bool_]

SIDES = ("top", "bottom", "left", "right")
"""Sides of a frame, in the order of `MaskFacts.cuts`."""


@dataclass(frozen=True, eq=False)
class MaskFacts:
    """What was found in each of F masks.

    Attributes
    ----------
    people : ndarray of int, shape (F,)
        Number of people.
    dropped : ndarray of int, shape (F,)
        Number of components that are no part of the person and were left out.
    dropped_area : ndarray, shape (F,)
        Their share of the foreground.
    cuts : ndarray, shape (F, 4)
        Width of the person where the sides of the frame, in the order of `SIDES`, cut it, as a
        share of the longer side of the person's bounding box; 0 where they do not.
    blank, fragment, filled : ndarray of bool, shape (F,)
        Masks in which there is no person: without foreground, with nothing but pieces too small
        to be a person, or whose foreground fills the frame.
    height : ndarray, shape (F,)
        Height of the person's bounding box, pixels; 0 where there is none.
    aspect : ndarray, shape (F,)
        Height over width of the person's bounding box; NaN where there is none.
    thumbnails : ndarray of uint8, shape (F, 24, 24)
        The person, 0 to 255, scaled so that the box's height fills the rows; 0 where there is
        none.
    """

    people: Indices
    dropped: Indices
    dropped_area: Array
    cuts: Array
    blank: Flags
    fragment: Flags
    filled: Flags
    height: Array
    aspect: Array
    thumbnails: NDArray[np.uint8]

    def __len__(self) -> int:
        return len(self.people)

    def __getitem__(self, frames: slice | Indices | Flags) -> Self:
        """Facts of some frames; a slice, indices or flags, so that they stay arrays."""
        return type(self)(**{name: value[frames] for name, value in self.to_arrays().items()})

    @property
    def cut_sides(self) -> Flags:
        """Which sides of the frame cut the person, shape (F, 4)."""
        return np.asarray(self.cuts > 0)

    @property
    def cut(self) -> Flags:
        """Whether the frame cuts the person, shape (F,)."""
        return np.asarray(self.cut_sides.any(axis=1))

    @property
    def seen(self) -> Flags:
        """Whether there is a person whose pose can be estimated, shape (F,)."""
        return ~(self.blank | self.fragment | self.filled)

    def states(self) -> list[str]:
        """Per frame ``blank``, ``fragment`` or ``filled`` where there is no person, else ``""``."""
        states = np.full(len(self), "", dtype=object)
        for name in ("blank", "fragment", "filled"):
            states[getattr(self, name)] = name
        return [str(state) for state in states]

    @classmethod
    def concatenate(cls, parts: Sequence[Self]) -> Self:
        """Join the facts of consecutive masks."""
        arrays = [part.to_arrays() for part in parts]
        return cls(**{name: np.concatenate([a[name] for a in arrays]) for name in arrays[0]})

    def to_arrays(self) -> dict[str, Any]:
        """Everything by name, as the constructor takes it."""
        return {field.name: getattr(self, field.name) for field in fields(self)}
