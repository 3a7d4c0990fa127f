"""`FilmMasks`: the masks of all frames of a film, packed, and the stretches with a person."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Self

import numpy as np

from silpose.core.errors import InputError
from silpose.core.progress import bar
from silpose.core.types import Array, Indices, Mask
from silpose.silhouette.masks import PackedMask
from silpose.silhouette.person import MaskFacts
from silpose.silhouette.video import VideoMasks, doubts_of, even_times

_AWAY = 1.0  # seconds without a person, after which it may be another one
_LONGEST = 600  # frames that are fitted together: their number takes memory
_FEWEST = 3  # frames of which something can be said


@dataclass(frozen=True, eq=False)
class FilmMasks:
    """Masks of the F frames of a film.

    Attributes
    ----------
    source : str
        What the film is called in messages.
    index : ndarray of int, shape (F,)
        Number of each frame in the film.
    time : ndarray, shape (F,)
        Seconds since the film's first frame.
    states : list of str
        State of each mask, as of `MaskedFrame`.
    facts : MaskFacts
        What is in each mask.
    packed : list of PackedMask
    frames_per_second : float
        Usual rate.
    """

    source: str
    index: Indices
    time: Array
    states: list[str]
    facts: MaskFacts
    packed: list[PackedMask]
    frames_per_second: float

    @classmethod
    def read(cls, video: VideoMasks) -> Self:
        """Segment a film; its pictures are not kept.

        Parameters
        ----------
        video : VideoMasks
            No camera, which does not end.

        Raises
        ------
        InputError
            If nobody is seen in any frame, or in one or two only.

        Warns
        -----
        UserWarning
            If many frames are doubtful.
        """
        index: list[int] = []
        time: list[float] = []
        states: list[str] = []
        facts: list[MaskFacts] = []
        packed: list[PackedMask] = []
        with bar("masks", video.frames.announced) as advance:
            for frame in video:
                index.append(frame.index)
                time.append(frame.time)
                states.append(frame.state)
                facts.append(frame.facts)
                packed.append(PackedMask.of(frame.mask))
                advance(1)
        joined, name = MaskFacts.concatenate(facts), video.frames.name
        seen = int(joined.seen.sum())
        if seen < _FEWEST:
            raise InputError(
                f"a person is told from the background in {seen} of {len(index)} frames of {name}: "
                "does the person move, and is there light enough, so that noise hides nobody? "
                "try silhouette.video.threshold=8, or give a picture of the empty scene, "
                "silhouette.video.background=FILE"
            )
        doubts_of(Counter(states), True, name)
        _, rate = even_times(np.array(time), video.frames_per_second)
        assert rate is not None, "there are several frames"
        return cls(name, np.array(index), np.array(time), states, joined, packed, rate)

    def __len__(self) -> int:
        return len(self.index)

    def mask(self, frame: int) -> Mask:
        """Unpack the mask (H, W) of a frame, counted from the first of these."""
        return self.packed[frame].mask

    @property
    def shape(self) -> tuple[int, int]:
        """Height and width of the pictures, pixels."""
        return self.packed[0].shape

    def stretches(self) -> Iterator[slice]:
        """Divide the film where nobody is seen for a second, and where a stretch is too long."""
        seen = np.flatnonzero(self.facts.seen)
        gaps = np.flatnonzero(np.diff(self.time[seen]) > _AWAY)
        for own in np.split(seen, gaps + 1):
            count = own[-1] + 1 - own[0]
            for part in np.array_split(np.arange(own[0], own[-1] + 1), -(-count // _LONGEST)):
                if self.facts.seen[part].sum() >= _FEWEST:
                    yield slice(int(part[0]), int(part[-1]) + 1)
