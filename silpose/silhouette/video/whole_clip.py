"""Masks of a whole clip at an even rate."""

from __future__ import annotations

import warnings
from collections import Counter
from collections.abc import Iterable, Mapping

import numpy as np

from silpose.core.types import Array, Indices, Mask
from silpose.silhouette.masks import MaskSequence
from silpose.silhouette.video.masked_frame import MaskedFrame

_UNEVEN = 0.6  # of an interval, by which a frame may be off an even rate
_BAD = 0.2  # share of the frames from which a state of theirs is said


def mask_sequence(frames: Iterable[MaskedFrame], source: str, rate: float | None) -> MaskSequence:
    """Collect the masks of a clip.

    Parameters
    ----------
    frames : iterable of MaskedFrame
    source : str
        What the clip is called in messages.
    rate : float or None
        Frames per second that the source tells.

    Returns
    -------
    sequence : MaskSequence
        Where frames come at uneven times, at their usual rate, each mask that of the frame
        nearest in time.

    Warns
    -----
    UserWarning
        If many frames are doubtful: after a light was switched, or without a person.
    """
    masks: list[Mask] = []
    names: list[str] = []
    time: list[float] = []
    states: Counter[str] = Counter()
    for frame in frames:  # pictures are not kept
        masks.append(frame.mask)
        names.append(f"frame {frame.index}")
        time.append(frame.time)
        states[frame.state] += 1
    order, even = even_times(np.array(time), rate)
    notes = [f"{count} frames: {state}" for state, count in states.items()]
    if len(order) != len(masks) or (order != np.arange(len(masks))).any():
        notes.append(f"frames at uneven times, taken {even:.4g} times a second")
    doubts = doubts_of(states, any(mask.any() for mask in masks), source)
    return MaskSequence(
        [masks[k] for k in order],
        [names[k] for k in order],
        source,
        "pictures without their background",
        even,
        tuple(notes),
        doubts,
    )


_HOW = "silhouette.video.background=FILE (in Python background='FILE')"
_WHY = {
    "switched": "the light changes too often for a background; give it constant light",
    "filled": "the background is another one; give a picture of the empty scene, " + _HOW,
    "fragment": "the person may stay in one place, and be a part of the background; give a picture "
    "of the empty scene, " + _HOW,
}


def doubts_of(states: Mapping[str, int], anybody: bool, source: str) -> tuple[str, ...]:
    """Say what may be wrong with a clip, and warn of it.

    Parameters
    ----------
    states : mapping of str to int
        How many frames are in which state.
    anybody : bool
        Whether there is a person in any frame.
    source : str
        What the clip is called in messages.

    Returns
    -------
    doubts : tuple of str
        A sentence each.
    """
    frames = sum(states.values())
    doubts = [
        f"{count} of {frames} frames of {source} are '{state}': {_WHY[state]}"
        for state, count in states.items()
        if state in _WHY and count > _BAD * frames
    ]
    if not anybody:
        doubts.append(
            f"nobody is told from the background in {source}: does the person move, and is there "
            "light? try silhouette.video.threshold=8 (in Python threshold=8), or give a picture of "
            f"the empty scene, {_HOW}"
        )
    for doubt in doubts:
        warnings.warn(doubt, UserWarning, stacklevel=4)
    return tuple(doubts)


def even_times(time: Array, rate: float | None) -> tuple[Indices, float | None]:
    """Choose the frame of each tick of an even rate.

    Parameters
    ----------
    time : ndarray, shape (F,)
        Seconds, increasing.
    rate : float or None
        Frames per second that the source tells.

    Returns
    -------
    order : ndarray of int
        A frame for each tick: all of them, if they are even already.
    rate : float or None
        Of the ticks; None for a single frame of unknown rate.
    """
    every = np.arange(len(time))
    if len(time) < 2:
        return every, rate
    usual = float(f"{1 / np.median(np.diff(time)):.6g}")
    if rate is None or abs(rate / usual - 1) > 0.5 * _UNEVEN:
        rate = usual
    steps = (time - time[0]) * rate
    if np.abs(steps - every).max() < _UNEVEN:
        return every, rate
    ticks = np.arange(round(steps[-1]) + 1)
    after = np.clip(np.searchsorted(steps, ticks), 1, len(steps) - 1)
    nearer = after - (ticks - steps[after - 1] < steps[after] - ticks)
    return np.asarray(nearer, np.intp), float(rate)
