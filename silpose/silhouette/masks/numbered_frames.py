"""`NumberedFrames`: when frames were taken, by the numbers in their names."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Decimal
from itertools import accumulate, pairwise
from pathlib import Path
from statistics import mean, median_low
from typing import Self

from silpose.silhouette.masks.natural_order import without_signs

_LAST = (
    re.compile(r"(.*?)(\d+(?:\.\d+)?)(\D*)"),  # the last number, perhaps with decimals
    re.compile(r"(|.*\D)(\d+)(\D*)"),  # what counts behind a dot
)
_JITTER = 0.25  # share of the usual step by which steps of a clock may be off
_SPARSE = 10  # steps of the smallest, on average, up to which frames were left out at random


@dataclass(frozen=True)
class NumberedFrames:
    """Frames counted by the last number in their names.

    Attributes
    ----------
    names : sequence of str
        With suffixes.
    numbers : list of int
        From 0; those that are missing are gaps. Consecutive where names differ in more than a
        number, or do not count in even steps.
    uneven : bool
        Whether names do count, but in no even steps.
    """

    names: Sequence[str]
    numbers: list[int]
    uneven: bool = False

    @classmethod
    def of(cls, names: Sequence[str]) -> Self:
        """Count frames by their names, which are in natural order."""
        consecutive = list(range(len(names)))
        steps = _steps([Path(name).stem for name in names])
        if not steps:
            return cls(names, consecutive)
        if (counts := _counted(steps)) is None:
            return cls(names, consecutive, True)
        return cls(names, [*accumulate(counts, initial=0)])

    def doubt(self, source: str, frames: str) -> str:
        """Say what is uncertain about their times; nothing where all is even.

        Parameters
        ----------
        source : str
            What holds them.
        frames : str
            What they are, as ``masks``.
        """
        if self.uneven:
            return (
                f"the numbers in the names of the {frames} in {source} rise unevenly, so that they "
                "tell no times, and one is taken to follow the other at the same interval: number "
                "them by time if that is wrong"
            )
        gaps = [k for k, (a, b) in enumerate(pairwise(self.numbers)) if b > a + 1]
        if not gaps:
            return ""
        missing = self.numbers[-1] + 1 - len(self.numbers)
        return (
            f"{missing} {frames} in {source} are missing by the numbers in their names, first "
            f"after '{self.names[gaps[0]]}', and leave gaps in time: if there are none, number the "
            f"{frames} anew"
        )


def _steps(names: Sequence[str]) -> list[Decimal]:
    """Differences of numbers that rise in names that are alike; none if they do not."""
    plain, below = without_signs(names)
    for last in _LAST:
        found = [match for name in plain if (match := last.fullmatch(name))]
        if len(found) < len(names) or len({(match[1], match[3]) for match in found}) != 1:
            continue
        every = [Decimal(m[2]) * (-1 if sign else 1) for m, sign in zip(found, below, strict=True)]
        steps = [b - a for a, b in pairwise(every)]
        if steps and min(steps) > 0:
            return steps
    return []


def _counted(steps: Sequence[Decimal]) -> list[int] | None:
    """Express steps as multiples of one; None if they are none."""
    middle = median_low(steps)
    usual = mean(step for step in steps if abs(step - middle) <= middle * Decimal(_JITTER))
    multiples = [max(1, round(step / usual)) for step in steps]
    off = (abs(step / usual - count) for step, count in zip(steps, multiples, strict=True))
    if max(off) <= _JITTER:
        return multiples
    least = min(steps)
    dense = all(step % least == 0 for step in steps) and mean(steps) <= _SPARSE * least
    return [int(step / least) for step in steps] if dense else None
