"""Failures injected into takes, and the time that a tracker needs to recover from them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Self, TypeVar

import numpy as np

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array, Examples
from silpose.dataset import Take
from silpose.evaluation.heading import HEADING_LIMIT_DEG, heading_errors

Track = Callable[[Array], Array]
"""From descriptors (F, d), NaN where a mask is blank, to poses (F, D)."""
Place = TypeVar("Place")

BEFORE = 2.0  # seconds that are tracked before a failure,
AFTER = 2.0  # and after it
STEADY = 0.2  # seconds on end with the heading within its limit until a track counts as recovered


@dataclass(frozen=True)
class FailureSequence:
    """A take with two failures: blank masks for a while, and later a cut back in time.

    Attributes
    ----------
    take : Take
        Its frames in the order of the sequence.
    z : ndarray, shape (F, d)
        A row of NaN is a blank mask.
    cut : int
        First frame after the cut.
    """

    take: Take
    z: Array
    cut: int

    @classmethod
    def of(cls, take: Take, z: Array, blank_frames: int) -> Self:
        """Inject both failures into a take with descriptors ``z (F, d)``."""
        frames = len(take)
        cut = 2 * frames // 3
        order = np.r_[0:cut, frames // 6 : frames // 2]
        blank = slice(frames // 3, min(frames // 3 + blank_frames, frames // 2))
        z, masks = z[order], None
        z[blank] = np.nan
        if take.masks is not None:
            masks = np.asarray(take.masks)[order]
            masks[blank] = 0
        take = replace(take, x=take.x[order], offset=take.offset[order], masks=masks, z=None)
        return cls(take, z, cut)


@dataclass(frozen=True)
class FailureTrial:
    """A short sequence with one failure in it.

    Attributes
    ----------
    z, x : ndarray, shapes (F, d) and (F, D)
        A row of NaN in z is a blank mask.
    end : int
        First frame after the failure.
    """

    z: Array
    x: Array
    end: int

    @classmethod
    def blank(cls, z: Array, x: Array, at: int, frames: int, rate: float) -> Self:
        """Blank some frames of a take.

        Parameters
        ----------
        z, x : ndarray, shapes (F, d) and (F, D)
        at, frames : int
            First blank frame, and their number.
        rate : float
            Frames per second.
        """
        first, end = max(0, at - round(BEFORE * rate)), at + frames
        part = slice(first, end + round(AFTER * rate))
        z, x = z[part].copy(), x[part]
        z[at - first : end - first] = np.nan
        return cls(z, x, end - first)

    @classmethod
    def cut(
        cls, one: tuple[Array, Array], at: int, other: tuple[Array, Array], to: int, rate: float
    ) -> Self:
        """Cut from one take to another.

        Parameters
        ----------
        one, other : tuple of ndarray, shapes (F, d) and (F, D)
            Descriptors and poses of each.
        at, to : int
            First frame of `one` that is left out, first frame of `other` that follows instead.
        rate : float
            Frames per second.
        """
        first, last = max(0, at - round(BEFORE * rate)), to + round(AFTER * rate)
        z, x = (np.concatenate([a[first:at], b[to:last]]) for a, b in zip(one, other, strict=True))
        return cls(z, x, at - first)

    def recovery_seconds(self, space: PoseSpace, track: Track, rate: float) -> float:
        """Seconds from the failure's end until the heading is met again; infinite if it never is.

        Parameters
        ----------
        space : PoseSpace
        track : callable
            From descriptors (F, d) to poses (F, D).
        rate : float
            Frames per second.
        """
        errors = heading_errors(space, self.x, track(self.z))[self.end :]
        met = errors <= HEADING_LIMIT_DEG
        steady = round(STEADY * rate)
        for frame in range(len(met) - steady + 1):
            if met[frame : frame + steady].all():
                return frame / rate
        return np.inf


def blank_trials(examples: Examples, frames: int, count: int, rate: float) -> list[FailureTrial]:
    """Spread trials with blank masks evenly over takes.

    Parameters
    ----------
    examples : sequence of (z, x)
        Descriptors (F, d) and poses (F, D) of each take.
    frames, count : int
        Blank frames of a trial, and number of trials.
    rate : float
        Frames per second.
    """
    after = round(AFTER * rate)
    places = [
        (z, x, at)
        for z, x in examples
        for at in range(round(BEFORE * rate), len(z) - frames - after)
    ]
    return [FailureTrial.blank(z, x, at, frames, rate) for z, x, at in _spread(places, count)]


def cut_trials(examples: Examples, count: int, rate: float, seed: int) -> list[FailureTrial]:
    """Spread trials with a cut evenly over takes: to another take, or within the only one.

    Parameters
    ----------
    examples : sequence of (z, x)
        Descriptors (F, d) and poses (F, D) of each take.
    count : int
        Number of trials.
    rate : float
        Frames per second.
    seed : int
        Draws where each cut leads.
    """
    random, after = np.random.default_rng(seed), round(AFTER * rate)
    places = [
        (k, at) for k, (z, _) in enumerate(examples) for at in range(round(BEFORE * rate), len(z))
    ]
    targets = [(k, to) for k, (z, _) in enumerate(examples) for to in range(len(z) - after)]
    trials = []
    for k, at in _spread(places, count):
        away = [
            (j, to) for j, to in targets if j != k or (len(examples) == 1 and abs(to - at) > after)
        ]
        if away:
            j, to = away[random.integers(len(away))]
            trials.append(FailureTrial.cut(examples[k], at, examples[j], to, rate))
    return trials


def _spread(places: Sequence[Place], count: int) -> list[Place]:
    which = np.unique(np.linspace(0, len(places) - 1, count).round().astype(int))
    return [places[k] for k in which] if places else []
