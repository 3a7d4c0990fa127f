"""Masks of any origin with their descriptions: read, reduced to one person each, described."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.core.types import Array, Mask
from silpose.descriptor import ShapeContextHistogram
from silpose.silhouette import visible
from silpose.silhouette.masks import MaskSequence, MaskSource, read_masks
from silpose.silhouette.person import MaskFacts, select_person

_BLOCK = 256  # masks whose shape contexts are held at a time: they are large


@dataclass(frozen=True)
class DescribedMasks:
    """Masks of F frames, what they show, and their descriptions.

    Attributes
    ----------
    sequence : MaskSequence
        Where they come from; its masks are those of the person alone.
    facts : MaskFacts
        What was seen in each.
    z : ndarray, shape (F, d)
        Descriptors; NaN where there is no person.
    points : list of ndarray, each (P, 2)
        Edge points, pixels; none where there is no person.
    nearest : list of ndarray of int, each (P,)
        The codebook centre nearest to each.
    """

    sequence: MaskSequence
    facts: MaskFacts
    z: Array
    points: list[NDArray[np.int32]]
    nearest: list[NDArray[np.int32]]


def see_masks(source: object, options: MaskSource) -> tuple[MaskSequence, MaskFacts]:
    """Read masks, and keep one person in each.

    Parameters
    ----------
    source : path, array, list or iterable
        As of `read_masks`.
    options : MaskSource
        Its own source is not used.

    Raises
    ------
    InputError
        If the source cannot be read; if there are several people and none is chosen; if a mask
        shows nobody and `blank` is "error"; or if all masks show nobody.
    """
    sequence = read_masks(source, options)
    visible(sequence.masks, options.blank, sequence.names)
    chosen = select_person(
        sequence.masks, options.person, names=sequence.names, source=sequence.source
    )
    alone = MaskSequence(
        chosen.masks, sequence.names, sequence.source, sequence.encoding,
        sequence.frames_per_second, sequence.notes, sequence.doubts, sequence.ignored,
    )  # fmt: skip
    return alone, chosen.facts


def describe_masks(
    descriptor: ShapeContextHistogram, source: object, options: MaskSource
) -> DescribedMasks:
    """Read masks and describe those that show a person; errors are those of `see_masks`."""
    sequence, facts = see_masks(source, options)
    seen = np.flatnonzero(facts.seen)
    z = np.full((len(sequence), len(descriptor.codebook_)), np.nan)
    points = [np.empty((0, 2), np.int32)] * len(sequence)
    nearest = [np.empty(0, np.int32)] * len(sequence)
    for start in range(0, len(seen), _BLOCK):
        block = seen[start : start + _BLOCK]
        own: list[Mask] = [sequence.masks[frame] for frame in block]
        for frame, description in zip(block, descriptor.describe(own), strict=True):
            z[frame], points[frame] = description.z, description.points
            nearest[frame] = description.nearest
    return DescribedMasks(sequence, facts, z, points, nearest)


def mask_options(
    blank: str, frames_per_second: float | None, options: Mapping[str, Any]
) -> MaskSource:
    """Collect how masks are read; an `InputError` names an option that there is none of."""
    known = MaskSource().reading
    for name in options:
        if name not in known:
            raise InputError(f"there is no option '{name}': give one of {', '.join(known)}")
    return MaskSource(blank=blank, frames_per_second=frames_per_second, **options)


def spread(rows: Array, seen: NDArray[np.bool_]) -> Array:
    """Put a row of each frame that was seen (V, d) at its frame (F, d), and NaN elsewhere."""
    everywhere = np.full((len(seen), rows.shape[1]), np.nan)
    everywhere[seen] = rows
    return everywhere
