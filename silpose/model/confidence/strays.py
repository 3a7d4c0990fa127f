"""Estimates that stray towards those of other frames, as a tracker's or a fit's may."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Self

import numpy as np

from silpose.core.serialisation import State
from silpose.core.types import Array, Indices
from silpose.model.confidence.odd_frames import Frames

_EVERY = 3  # which frame as in training also has an estimate that strays


@dataclass(frozen=True, eq=False)
class Strays:
    """Which frames' estimates stray, how far, and towards which.

    Attributes
    ----------
    frames : ndarray of int, shape (S,)
        As in training.
    share : ndarray, shape (S, 1)
        Of the way.
    towards : ndarray of int, shape (S,)
        Places in `frames`.
    """

    frames: Indices
    share: Array
    towards: Indices

    @classmethod
    def draw(cls, frames: Frames, rng: np.random.Generator) -> Self:
        """Draw them."""
        clean = np.flatnonzero(~frames.odd)[::_EVERY]
        return cls(clean, rng.uniform(0.1, 1, (len(clean), 1)), rng.permutation(len(clean)))

    def of(self, estimated: Array) -> Array:
        """Make estimates (S, D) of all frames' (F, D); headings are as certain as before."""
        x = estimated[self.frames]
        stray = (1 - self.share) * x + self.share * x[self.towards]
        before, after = (np.hypot(own[:, :1], own[:, 1:2]) for own in (x, stray))
        stray[:, :2] *= before / np.maximum(after, 1e-6)
        return stray

    def to_arrays(self) -> State:
        """Everything by name, as the constructor takes it."""
        return {field.name: getattr(self, field.name) for field in fields(self)}
