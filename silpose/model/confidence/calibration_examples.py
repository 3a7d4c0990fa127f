"""What confidence is calibrated with, whatever the regressor: made once for each described dataset.

Making odd masks and describing them takes longer than all the rest of a calibration.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil
from typing import TYPE_CHECKING, Self

import numpy as np

from silpose.core.pose_space import PoseSpace
from silpose.core.serialisation import State, prefixed, without_prefix
from silpose.core.types import Examples
from silpose.dataset import Take
from silpose.descriptor import ShapeContextHistogram
from silpose.model.confidence.evidence import TrainingExamples
from silpose.model.confidence.odd_frames import (
    Frames,
    facts_of,
    frames_of_descriptors,
    frames_of_masks,
)
from silpose.model.confidence.strays import Strays
from silpose.regression.selection import partition
from silpose.silhouette.person import MaskFacts

if TYPE_CHECKING:
    from silpose.model.training import DescribedDataset

_EXAMPLES = 2000  # training examples that poses are compared with
_FOLDS = 4  # parts in which training takes are left out
_CLEAN, _ODD = 600, 1600  # frames, at most, of all parts together


@dataclass(frozen=True, eq=False)
class LeftOut:
    """Takes that are left out together.

    Attributes
    ----------
    frames : Frames
        Of these takes, as they are and odd.
    strays : Strays
        Which of their estimates stray.
    rest : sequence of int
        The training takes that are not left out.
    """

    frames: Frames
    strays: Strays
    rest: Sequence[int]

    def to_arrays(self) -> State:
        """Return everything as arrays."""
        return {
            "rest": np.array(self.rest, dtype=int),
            **prefixed("frames", self.frames.to_arrays()),
            **prefixed("strays", self.strays.to_arrays()),
        }

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore from the result of `to_arrays`."""
        frames = Frames.from_arrays(without_prefix("frames", state))
        return cls(frames, Strays(**without_prefix("strays", state)), state["rest"].tolist())


@dataclass(frozen=True, eq=False)
class CalibrationExamples:
    """Examples of training, and frames that are judged against them.

    Attributes
    ----------
    training : list of TrainingExamples
        Of each training take.
    parts : list of LeftOut
    """

    training: Sequence[TrainingExamples]
    parts: Sequence[LeftOut]

    @classmethod
    def of(cls, described: DescribedDataset) -> Self:
        """Make them, or read them where they were kept with the dataset's descriptors."""
        takes, space = [*described.data.train, *described.data.validation], described.data.space
        arrays = described.known.recall_arrays(
            lambda: cls._made(described).to_arrays(),
            "confidence", described.train, described.validation, described.groups, space,
            [(take.has_masks, take.camera) for take in takes],
        )  # fmt: skip
        return cls.from_arrays(arrays, space)

    @classmethod
    def _made(cls, described: DescribedDataset) -> Self:
        rng = np.random.default_rng(0)
        parts = parts_of(described)
        made = []
        for takes, examples, rest in parts:
            frames = _frames(takes, examples, described.descriptor, len(parts), rng)
            made.append(LeftOut(frames, Strays.draw(frames, rng), rest))
        return cls(_training_examples(described), made)

    def to_arrays(self) -> State:
        """Return everything as arrays."""
        state: State = {"parts": len(self.parts), "takes": len(self.training)}
        for k, part in enumerate(self.parts):
            state |= prefixed(f"part{k}", part.to_arrays())
        for k, examples in enumerate(self.training):
            state |= prefixed(f"take{k}", examples.to_arrays())
        return state

    @classmethod
    def from_arrays(cls, state: State, space: PoseSpace) -> Self:
        """Restore from the result of `to_arrays`."""
        return cls(
            [
                TrainingExamples(**without_prefix(f"take{k}", state), space=space)
                for k in range(int(state["takes"]))
            ],
            [
                LeftOut.from_arrays(without_prefix(f"part{k}", state))
                for k in range(int(state["parts"]))
            ],
        )


Part = tuple[Sequence[Take], Examples, list[int]]
"""Takes that are held out together, their examples, and the training takes that are not."""


def parts_of(described: DescribedDataset) -> list[Part]:
    """Training takes in a few parts, and the validation takes.

    Where nothing can be left out, the training takes are judged as if they had been.
    """
    data, examples = described.data, described.train
    everything = list(range(len(examples)))
    parts: list[Part] = [
        ([data.train[k] for k in own], [examples[k] for k in own], rest)
        for own in left_out(described)
        if (rest := [k for k in everything if k not in own])
    ]
    if data.validation:
        parts.append((data.validation, described.validation, everything))
    return parts or [(data.train, examples, everything)]


def left_out(described: DescribedDataset) -> list[set[int]]:
    """Which training takes are left out together."""
    lengths, groups = [len(x) for _, x in described.train], described.groups
    if len(lengths) < 2 or (groups is not None and len(set(groups)) < 2):
        return []
    parts = partition(lengths, _FOLDS, groups)
    while len(parts) > _FOLDS:  # of many performers, several are left out together
        parts = [a | b for a, b in zip(parts[::2], [*parts[1::2], set()], strict=False)]
    return parts


def _frames(
    takes: Sequence[Take],
    examples: Examples,
    descriptor: ShapeContextHistogram | None,
    parts: int,
    rng: np.random.Generator,
) -> Frames:
    """Frames of the takes of one part, as they are and odd."""
    count = sum(len(take) for take in takes)
    clean, odd = min(count, _CLEAN // parts), min(2 * count, _ODD // parts)
    if descriptor is not None and all(take.has_masks for take in takes):
        return frames_of_masks(takes, descriptor, clean, odd, rng)
    z, x = (np.concatenate(own) for own in zip(*examples, strict=True))
    return frames_of_descriptors(z, x, clean, odd, rng)


def _training_examples(described: DescribedDataset) -> list[TrainingExamples]:
    """Evenly spaced examples of each training take."""
    space, takes = described.data.space, described.data.train
    every = ceil(sum(len(x) for _, x in described.train) / _EXAMPLES)
    frames = slice(every // 2, None, every)
    return [
        TrainingExamples.of(z[frames], x[frames], _facts(take, frames), space)
        for take, (z, x) in zip(takes, described.train, strict=True)
    ]


def _facts(take: Take, frames: slice) -> MaskFacts | None:
    own = np.arange(len(take))[frames]
    return facts_of(take.masks_at(own))[1] if take.has_masks and len(own) else None
