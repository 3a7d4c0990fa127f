"""Tracks that begin at every frame of a take in turn.

What a tracker remembers fades: a track that began a frame earlier soon is the same. So each is
followed until it is as the one before, whose estimates then serve on.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from silpose.core.types import Array
from silpose.tracking.belief_filter import expected_ahead, smooth
from silpose.tracking.belief_tracker import BeliefTracker
from silpose.tracking.key_examples import KeyPoseComparison
from silpose.tracking.single_pose_tracker import GIVEN, SinglePoseTracker

_SAME = 1e-8  # largest difference of what two tracks remember that go on as one

Step = Callable[[int], Array]
"""From a frame to all that a track remembers after it, from which the rest follows."""


def belief_tracks(
    tracker: BeliefTracker, z: Array, lag: int = 0, *, backwards: bool = False
) -> Iterator[Array]:
    """Track a take by a belief, from every frame in turn.

    Parameters
    ----------
    tracker : BeliefTracker
        Fitted, with ``restart=0``: it never starts again.
    z : ndarray, shape (F, d)
        Descriptors.
    lag : int, default=0
        As of `Tracker.track`.
    backwards : bool, default=False
        Whether z is in the order of a time that goes backwards.

    Yields
    ------
    x : ndarray, shape (F - k, D)
        Poses from row k of z on, for k = 0, 1, …, F - 1: as those that ``tracker.track`` finds,
        to a millionth.
    """
    comparison = tracker.examples_.compare(z)
    likelihoods = tracker.likelihoods(comparison)
    transitions = (
        tracker.transitions_.reversed(tracker.sizes_) if backwards else tracker.transitions_
    )
    ahead = expected_ahead(likelihoods, transitions, lag)

    def begin(start: int) -> Step:
        run = tracker.bayes_filter(transitions)
        return lambda frame: run.step(likelihoods[frame], bool(comparison.blank[frame]))[0]

    def poses(beliefs: Array, frames: slice) -> Array:
        seen = KeyPoseComparison(comparison.descriptors[frames], comparison.distances[frames])
        return tracker.regress(smooth(beliefs, ahead[frames]), seen)

    return _tracks(len(z), begin, poses)


def single_pose_tracks(tracker: SinglePoseTracker, z: Array, initial: Array) -> Iterator[Array]:
    """Track a take by a single pose, from every frame in turn.

    Parameters
    ----------
    tracker : SinglePoseTracker
        Fitted.
    z : ndarray, shape (F, d)
        Descriptors.
    initial : ndarray, shape (F, D)
        Poses to start from: at frame k those of frames k and k + 1.

    Yields
    ------
    x : ndarray, shape (F - k, D)
        As those of ``tracker.track(z[k:], initial[k:k + 2])`` to a millionth.
    """

    def begin(start: int) -> Step:
        known = initial[start : start + GIVEN]
        run = tracker.begin(known, len(known))

        def step(frame: int) -> Array:
            if frame == start:  # what is before is unknown
                return np.concatenate([np.full_like(run.last, np.nan), run.before])
            if frame >= start + GIVEN:
                tracker.advance(run, z[frame])
            return np.concatenate([run.before, run.last])

        return step

    return _tracks(len(z), begin, lambda memory, frames: memory[:, memory.shape[1] // 2 :])


def _tracks(
    count: int, begin: Callable[[int], Step], poses: Callable[[Array, slice], Array]
) -> Iterator[Array]:
    """Track from each of `count` frames; `poses` are those of what is remembered after frames."""
    memory: list[Array | None] = [None] * count  # after each frame, of the track before
    x: Array | None = None
    for start in range(count):
        step, end = begin(start), count
        for frame in range(start, count):
            now = step(frame)
            before, memory[frame] = memory[frame], now
            if before is not None and np.abs(now - before).max() <= _SAME:
                end = frame + 1
                break
        own = poses(np.array(memory[start:end]), slice(start, end))
        x = own if x is None else np.concatenate([own, x[end - start + 1 :]])
        yield x
