"""A dataset whose masks have suffered."""

from __future__ import annotations

from collections.abc import Sequence as Ordered
from dataclasses import replace

from silpose.dataset.sequence import Dataset, Sequence
from silpose.silhouette import Degradation


def degraded(data: Dataset, degradation: Degradation) -> Dataset:
    """Degrade the masks for training and validation, and those for testing, as the settings say.

    Sequences that hold descriptors instead of masks stay as they are.
    """

    def spoil(takes: Ordered[Sequence], kinds: list[str]) -> Ordered[Sequence]:
        if not kinds:
            return takes
        return [
            take
            if take.masks is None
            else replace(take, masks=degradation.apply(take.masks, kinds, take.name))
            for take in takes
        ]

    return replace(
        data,
        train=spoil(data.train, degradation.train),
        validation=spoil(data.validation, degradation.train),
        test=spoil(data.test, degradation.test),
    )
