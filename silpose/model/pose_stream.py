"""Live: from one mask after another to poses, tracked or fitted."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.one_thread import OneThread
from silpose.core.types import Array, Mask
from silpose.fitting import SHAPES, Fit, FitterStream
from silpose.model.answers import confidence_of, confidence_of_fit, warn_without_calibration
from silpose.model.pose_fitter import PoseFitter
from silpose.model.poses import Poses
from silpose.silhouette.masks import MaskReader, MaskSource
from silpose.silhouette.person import MaskFacts, PersonSelector
from silpose.tracking import TimedStream
from silpose.tracking.checks import checked_time

if TYPE_CHECKING:
    from silpose.model.pose_model import PoseModel

Estimate = Callable[[Array, float], tuple[Array, str]]
"""From a descriptor (d,), of NaN if nobody was seen, and its time to a pose (D,) and a state."""


class PoseStream:
    """A model under way: it answers one mask after another, and changes nothing in the model.

    Parameters
    ----------
    model : PoseModel
    fitter : PoseFitter, optional
        Fits the body to each mask, from the tracker's pose, or the regressor's if there is no
        tracker.
    frames_per_second : float, optional
        Rate of frames that come without a time; by default the model's.
    options : MaskSource, optional
        How masks are read, and who is chosen if there are several people.
    """

    def __init__(
        self,
        model: PoseModel,
        fitter: PoseFitter | None = None,
        frames_per_second: float | None = None,
        options: MaskSource | None = None,
    ) -> None:
        if model.confidence is None and fitter is None:
            warn_without_calibration()
        options = options or MaskSource()
        self._model, self._fitter = model, fitter
        self._interval = 1 / (frames_per_second or model.frames_per_second)
        self._reader, self._selector = MaskReader(options), PersonSelector(options.person)
        tracking = None if model.tracker is None else TimedStream(model.tracker)
        self._estimate: Estimate = self._alone if tracking is None else tracking.step
        self._fitting: FitterStream | None = None
        self._time, self._last = -self._interval, -np.inf

    def step(self, mask: ArrayLike, time: float | None = None) -> Poses:
        """Estimate the pose behind the next mask.

        Parameters
        ----------
        mask : array-like, shape (H, W) or (H, W, C)
            Blank or not, of any encoding.
        time : float, optional
            Seconds, later than the frame before; by default one interval after it, the first
            at 0.

        Returns
        -------
        poses : Poses
            Of one frame.

        Raises
        ------
        InputError
            If the mask cannot be read, or its time is no finite number, or not after that of the
            frame before.
        """
        with OneThread():
            return self._step(mask, time)

    __call__ = step

    def _step(self, mask: ArrayLike, time: float | None) -> Poses:
        now = self._time + self._interval if time is None else checked_time(time, self._last)
        passed = now - self._time
        alone, facts = self._selector.step(self._reader.step(mask))
        if not (seen := bool(facts.seen[0])):
            alone = np.zeros_like(alone)  # what is no person has nothing to fit to
        z = self._describe(alone, seen)
        x, state = self._estimate(z, now)
        self._time = self._last = now
        if self._fitter is not None:
            return self._fit(alone, x, passed, facts)
        confidence = confidence_of(self._model, z[None], x[None], facts)
        own = x[None], self._model.space, confidence, [state]
        return Poses(*own, np.array([now]), facts=facts)

    def _describe(self, mask: Mask, seen: bool) -> Array:
        descriptor = self._model.descriptor
        assert descriptor is not None, "the model was checked when the stream was started"
        if not seen:
            return np.full(len(descriptor.codebook_), np.nan)
        return descriptor.transform([mask])[0]

    def _alone(self, z: Array, time: float) -> tuple[Array, str]:
        """Estimate a frame by itself."""
        if np.isfinite(z).all():
            return self._model.regressor.predict(z[None])[0], "estimated"
        return np.full(len(self._model.space.columns), np.nan), "blank"

    def _fit(self, mask: Mask, x: Array, passed: float, facts: MaskFacts) -> Poses:
        assert self._fitter is not None
        if self._fitting is None:  # the first mask says how large they are
            tracked = self._model.tracker is not None
            self._fitting = self._fitter.stream(mask.shape, 1 / self._interval, tracked=tracked)
        elif (missed := round(passed / self._interval) - 1) > 0:
            self._fitting.skip(missed)
        fitted, state = self._fitting.step(mask, x)
        fit = _last_fit(self._fitting, fitted, state, self._fitter.fitter.camera.elevation)
        confidence = confidence_of_fit(self._model, fit, facts)
        own = fitted[None], self._model.space, confidence, [state]
        return Poses(*own, np.array([self._time]), iou=fit.iou, facts=facts, fit=fit)


def _last_fit(stream: FitterStream, x: Array, state: str, elevation: float) -> Fit:
    """Collect what a stream knows of its last frame."""
    return Fit(
        x[None], stream.covariance[None], np.array([stream.iou]), np.array([stream.confidence]),
        [state], stream.shift[None], np.array([stream.scale]), elevation, np.zeros(SHAPES),
        x[None, None], np.ones((1, 1)), stream.evidence[None],
    )  # fmt: skip
