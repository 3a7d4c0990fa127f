"""Failures that are put into sequences on purpose, and how long a tracker takes to come back."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.dataset import Take
from silpose.evaluation import heading_errors

Array = NDArray[np.float64]
Examples = Sequence[tuple[Array, Array]]
Follow = Callable[[Array], Array]

BEFORE = 2.0  # seconds that are tracked before a failure,
AFTER = 2.0  # and after it
BACK_DEG = 20.0  # heading error within which a track is back,
STEADY = 0.2  # for so many seconds on end


@dataclass(frozen=True)
class FailureSequence:
    """A take to be watched: blank for a while, and later cut back in time.

    Attributes
    ----------
    take : Sequence
    z : ndarray, shape (F, d)
        A row of NaN is a blank mask.
    cut : int
        First frame after the cut.
    """

    take: Take
    z: Array
    cut: int

    @classmethod
    def of(cls, take: Take, z: Array, blank_frames: int) -> FailureSequence:
        """Put both failures into a take."""
        frames = len(take)
        cut = 2 * frames // 3
        order = np.r_[0:cut, frames // 6 : frames // 2]
        gone = slice(frames // 3, min(frames // 3 + blank_frames, frames // 2))
        z, masks = z[order], None
        z[gone] = np.nan
        if take.masks is not None:
            masks = np.asarray(take.masks)[order]
            masks[gone] = 0
        take = replace(take, x=take.x[order], offset=take.offset[order], masks=masks, z=None)
        return cls(take, z, cut)


@dataclass(frozen=True)
class Trial:
    """A sequence with one failure in it.

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
    def blank(cls, z: Array, x: Array, at: int, frames: int, rate: float) -> Trial:
        """Let nothing be seen for some frames."""
        first, end = max(0, at - round(BEFORE * rate)), at + frames
        part = slice(first, end + round(AFTER * rate))
        z, x = z[part].copy(), x[part]
        z[at - first : end - first] = np.nan
        return cls(z, x, end - first)

    @classmethod
    def cut(cls, one: tuple[Array, Array], at: int, other: tuple[Array, Array], to: int,
            rate: float) -> Trial:  # fmt: skip
        """Go on with another take at once."""
        first, last = max(0, at - round(BEFORE * rate)), to + round(AFTER * rate)
        z, x = (np.concatenate([a[first:at], b[to:last]]) for a, b in zip(one, other, strict=True))
        return cls(z, x, at - first)

    def seconds(self, space: PoseSpace, follow: Follow, rate: float) -> float:
        """Seconds from the failure's end until the track is back; infinite if it never is."""
        met = heading_errors(space, self.x, follow(self.z))[self.end :] <= BACK_DEG
        steady = round(STEADY * rate)
        for frame in range(len(met) - steady + 1):
            if met[frame : frame + steady].all():
                return frame / rate
        return np.inf


def blanks(examples: Examples, frames: int, count: int, rate: float) -> list[Trial]:
    """Make trials with blank frames, spread evenly over sequences."""
    room = round(AFTER * rate)
    places = [
        (z, x, at)
        for z, x in examples
        for at in range(round(BEFORE * rate), len(z) - frames - room)
    ]
    return [Trial.blank(z, x, at, frames, rate) for z, x, at in _spread(places, count)]


def cuts(examples: Examples, count: int, rate: float, seed: int) -> list[Trial]:
    """Make trials with a cut: to another sequence, or to another place of the only one."""
    random, room = np.random.default_rng(seed), round(AFTER * rate)
    places = [
        (k, at) for k, (z, _) in enumerate(examples) for at in range(round(BEFORE * rate), len(z))
    ]
    targets = [(k, to) for k, (z, _) in enumerate(examples) for to in range(len(z) - room)]
    trials = []
    for k, at in _spread(places, count):
        away = [
            (j, to) for j, to in targets if j != k or (len(examples) == 1 and abs(to - at) > room)
        ]
        if away:
            j, to = away[random.integers(len(away))]
            trials.append(Trial.cut(examples[k], at, examples[j], to, rate))
    return trials


def _spread(places: list, count: int) -> list:
    which = np.unique(np.linspace(0, len(places) - 1, count).round().astype(int))
    return [places[k] for k in which] if places else []
