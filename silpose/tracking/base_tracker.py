"""The interface of all trackers: fit to takes, track a take, or start a stream of frames."""

from __future__ import annotations

from abc import ABC, abstractmethod
from copy import copy
from typing import Generic, Self, TypeVar

import numpy as np
from numpy.typing import ArrayLike
from sklearn.base import BaseEstimator
from sklearn.utils.validation import check_is_fitted

from silpose.core.default_parts import DefaultParts
from silpose.core.errors import InputError
from silpose.core.serialisation import State
from silpose.core.types import Array
from silpose.tracking.checks import (
    check_finite,
    check_not_negative,
    check_table,
    checked_rate,
    numbers,
)
from silpose.tracking.takes import GivenTakes
from silpose.tracking.track import Track

SAME_RATE = 0.02
"""Relative difference up to which frame rates count as the same."""

Run = TypeVar("Run")
"""Kind of filter that a tracker runs over frames."""


class Tracker(ABC, DefaultParts, BaseEstimator, Generic[Run]):
    """Estimates poses over time from descriptors.

    A fitted tracker is not changed by using it: `track` and `start` may be called in any order,
    and several streams may run at once.
    """

    frames_per_second: float

    @abstractmethod
    def fit(self, takes: GivenTakes, y: object = None) -> Self:
        """Fit to training takes.

        Parameters
        ----------
        takes : sequence
            Descriptors (F, d) and poses (F, D) of each training take: a pair (z, x), or a function
            without arguments that returns one. Functions are called several times.
        y : None
            Ignored.

        Raises
        ------
        InputError
            If a parameter or a take cannot be used; the take is named by its index.
        """

    @abstractmethod
    def track(
        self,
        z: ArrayLike,
        initial: ArrayLike | None = None,
        lag: int = 0,
        frames_per_second: float | None = None,
    ) -> Track:
        """Track a take.

        Parameters
        ----------
        z : array-like, shape (F, d)
            Descriptors; a row of NaN where there was nothing to see.
        initial : array-like, shape (P, D), optional
            Poses of the first frames, if known beforehand, for instance by fitting a body to them.
        lag : int, default=0
            Number of later frames that each estimate may wait for.
        frames_per_second : float, optional
            Frame rate of the take, if known.

        Returns
        -------
        track : Track

        Raises
        ------
        InputError
            If the frame rate is not the training takes', an array has another shape, known poses
            are not finite, descriptors or the lag negative.
        """

    @abstractmethod
    def start(self, initial: ArrayLike | None = None) -> TrackerStream[Run]:
        """Start a stream of frames.

        Parameters
        ----------
        initial : array-like, shape (P, D), optional
            Poses of the frames before the first one, if known.
        """

    @abstractmethod
    def to_arrays(self) -> State:
        """Return parameters and fitted attributes as arrays, numbers and strings."""

    @classmethod
    @abstractmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore a tracker from the result of `to_arrays`."""

    @property
    @abstractmethod
    def columns(self) -> tuple[int, int]:
        """Number of columns of descriptors and of poses, d and D."""

    @abstractmethod
    def advance(self, run: Run, z: Array) -> tuple[Array, str]:
        """Let a filter take one frame more, with descriptor (d,); return pose (D,) and state."""

    def modes(self, run: Run, k: int) -> tuple[Array, Array]:
        """Return the k most probable poses of a filter, as `TrackerStream.modes` describes."""
        raise InputError("this tracker has one pose a frame: use a MultipleHypothesisTracker")

    def _checked(
        self, z: ArrayLike, initial: ArrayLike | None, frames_per_second: float | None
    ) -> tuple[Array, Array]:
        """Check what is to be tracked; return descriptors (F, d) and known poses (P, D)."""
        known = self._known(initial)
        trained = self.frames_per_second
        rate = trained if frames_per_second is None else checked_rate(frames_per_second)
        if abs(rate / trained - 1) > SAME_RATE:
            raise InputError(
                f"this tracker was trained at {trained:g} frames per second and cannot follow "
                f"{rate:g}: use silpose.tracking.track_at, which resamples the take"
            )
        z = numbers(z, "descriptors")
        check_table(z, "descriptors", self.columns[0])
        check_not_negative(z, "descriptors")
        if len(z) == 0:
            raise InputError("there is no frame to track: give one descriptor or more")
        return z, known[: len(z)]

    def _known(self, initial: ArrayLike | None) -> Array:
        """Check known poses; return them with shape (P, D), P = 0 if there are none."""
        check_is_fitted(self)
        columns = self.columns[1]
        if initial is None:
            return np.empty((0, columns))
        known = np.atleast_2d(numbers(initial, "initial poses"))
        if known.ndim != 2 or known.shape[1] != columns:
            raise InputError(f"initial poses have shape {known.shape}: expected (poses, {columns})")
        check_finite(known, "initial poses", "give poses that are known, or leave 'initial' out")
        return known


class TrackerStream(Generic[Run]):
    """A tracker under way: it holds what has been seen, and changes nothing in the tracker.

    Parameters
    ----------
    tracker : Tracker
        Fitted; changing it later does not change the stream.
    run : object
        The running filter.
    """

    def __init__(self, tracker: Tracker[Run], run: Run) -> None:
        self._tracker, self._run = copy(tracker), run
        self._shape = (tracker.columns[0],)

    def step(self, z: ArrayLike) -> tuple[Array, str]:
        """Track one frame more.

        Parameters
        ----------
        z : array-like, shape (d,)
            Its descriptor; NaN where there was nothing to see.

        Returns
        -------
        x : ndarray, shape (D,)
            Its pose.
        state : str
            One of `silpose.tracking.STATES`.

        Raises
        ------
        InputError
            If the descriptor has another length, or is negative.
        """
        z = numbers(z, "values of the descriptor")
        if z.shape != self._shape:
            raise InputError(f"a descriptor has shape {z.shape}: expected {self._shape}")
        check_not_negative(z[None], "descriptors")
        return self._tracker.advance(self._run, z)

    def fork(self) -> TrackerStream[Run]:
        """Return a second stream in the same state; neither changes the other."""
        return TrackerStream(self._tracker, copy(self._run))

    def modes(self, k: int) -> tuple[Array, Array]:
        """Return the most probable poses after a step.

        Parameters
        ----------
        k : int
            Number of modes, from 1 to 8.

        Returns
        -------
        weights : ndarray, shape (k,)
            Probabilities, the largest first; 0 where there are fewer than k.
        means : ndarray, shape (k, D)

        Raises
        ------
        InputError
            If the tracker has one pose a frame only.
        """
        return self._tracker.modes(self._run, k)
