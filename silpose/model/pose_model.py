"""`PoseModel`: fitted descriptor, regressor, tracker and fitter, from masks to poses."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.core.errors import InputError
from silpose.core.pose_space import PoseSpace
from silpose.core.serialisation import State, prefixed
from silpose.core.types import Array
from silpose.descriptor import ShapeContextHistogram
from silpose.fitting import Fit
from silpose.model.described_masks import DescribedMasks
from silpose.model.live_fitting import fitting_stream
from silpose.model.model_file import write_model_file
from silpose.model.pose_fitter import PoseFitter
from silpose.model.poses import Poses, PredictionDetails
from silpose.regression import Regressor
from silpose.silhouette import MaskFiles, is_blank, visible
from silpose.tracking import Track, Tracker

Masks = NDArray[Any] | Sequence[ArrayLike]

PARTS = ("descriptor", "regressor", "tracker", "fitter")
"""Parts of a model, by which its file names their arrays."""

_LAG = 0.5  # seconds that a tracker waits for later masks where all are fitted together


@dataclass
class PoseModel:
    """From masks to poses.

    Attributes
    ----------
    descriptor : ShapeContextHistogram or None
        None for a model that was trained on descriptors of unknown origin.
    regressor : Regressor
    space : PoseSpace
        Meaning of the poses' columns.
    frames_per_second : float
        Frame rate of the training takes.
    tracker : Tracker or None
        None for a model of single images.
    fitter : PoseFitter or None
        None for a model that was trained without.

    See Also
    --------
    silpose.load : Loads a saved model.
    """

    descriptor: ShapeContextHistogram | None
    regressor: Regressor
    space: PoseSpace
    frames_per_second: float
    tracker: Tracker | None = None
    fitter: PoseFitter | None = None

    def fit(self, masks: Masks, x: ArrayLike) -> Self:
        """Fit the codebook and the regressor.

        Parameters
        ----------
        masks : array-like, shape (n, H, W), or list of arrays (H, W)
        x : array-like, shape (n, D)
            The poses behind the masks.
        """
        z = self._descriptor().fit_transform(masks)
        self.regressor.fit(z, np.asarray(x))
        return self

    def predict(
        self,
        masks: str | Path | Masks,
        blank: str = "error",
        *,
        fit: bool = False,
        frames_per_second: float | None = None,
    ) -> Poses:
        """Estimate the pose behind each mask.

        Parameters
        ----------
        masks : array-like, shape (F, H, W), list of arrays (H, W), or path of a folder or video
        blank : {"error", "nan"}, default="error"
            Whether a mask without foreground is an error, or gives a row of NaN.
        fit : bool, default=False
            Whether to fit the body to the masks, which are consecutive frames then; the poses
            have an overlap and a state.
        frames_per_second : float, optional
            Frame rate of the masks, for the fit; by default the model's.

        Returns
        -------
        poses : Poses

        Raises
        ------
        InputError
            If a mask is blank, or if the model was trained on descriptors only, or without a
            fitter.
        """
        if not fit:
            return Poses(self.explain(masks, blank).x, self.space)
        self._fitter()  # before time is spent on masks
        fitted = self.fit_body(self.explain(masks, blank), frames_per_second)
        return Poses(fitted.x, self.space, fitted.iou, fitted.state, fitted.confidence)

    def fit_body(self, details: PredictionDetails, frames_per_second: float | None = None) -> Fit:
        """Fit the body to consecutive masks, from the tracker's poses if the model has one."""
        lag = round(_LAG * self.frames_per_second)
        tracked = self.tracker.track(details.z, lag=lag).x if self.tracker else None
        rate = frames_per_second or self.frames_per_second
        return self._fitter().fit(
            details.masks, details.z, details.x, tracked=tracked, frames_per_second=rate
        )

    def explain(self, masks: str | Path | Masks, blank: str = "error") -> PredictionDetails:
        """Estimate poses as `predict` does, with all intermediate results."""
        described = self._describe(masks, blank)
        points = [np.empty((0, 2), np.int32)] * len(described.masks)
        nearest = [np.empty(0, np.int32)] * len(described.masks)
        for frame, own in zip(described.visible, described.descriptions, strict=True):
            points[frame], nearest[frame] = own.points, own.nearest
        z = described.z
        seen = self.explain_descriptors(z[described.visible])
        activations, x = described.spread(seen.activations), described.spread(seen.x)
        return PredictionDetails(described.masks, points, nearest, z, activations, x)

    def explain_descriptors(self, z: Array) -> PredictionDetails:
        """Estimate poses from descriptors ``z (F, d)``, without masks."""
        x, activations = self.regressor.predict_with_activations(z)
        return PredictionDetails([], [], [], z, activations, x)

    def track(
        self, masks: str | Path | Masks, lag: int = 0, frames_per_second: float | None = None
    ) -> Track:
        """Track a person through masks, of which some may be blank.

        Parameters
        ----------
        masks : array-like, shape (F, H, W), list of arrays (H, W), or path of a folder or video
        lag : int, default=0
            Number of later frames that each estimate may wait for.
        frames_per_second : float, optional
            Frame rate of the masks, if known.

        Raises
        ------
        InputError
            If the model has no tracker, or one that was trained at another frame rate.
        """
        tracker = self._tracker()
        described = self._describe(masks, blank="nan")
        return tracker.track(described.z, lag=lag, frames_per_second=frames_per_second)

    def stream(self, *, fit: bool = False) -> Callable[[ArrayLike], tuple[Array, str]]:
        """Start tracking live.

        Parameters
        ----------
        fit : bool, default=False
            Whether to fit the body to each mask, from the tracker's pose if the model has a
            tracker, and from the regressor's otherwise.

        Returns
        -------
        step : callable
            From the next mask (H, W), blank or not, to its pose (D,) and the track's state.
        """
        if fit:
            parts = self._fitter(), self._descriptor_of, self._live_estimate()
            tracked = self.tracker is not None
            return fitting_stream(*parts, self.frames_per_second, tracked=tracked)
        running = self._tracker().start()
        return lambda mask: running.step(self._descriptor_of(mask))

    def _live_estimate(self) -> Callable[[Array], Array]:
        """From a descriptor (d,), perhaps of NaN, to a pose (D,): tracked if the model can."""
        if self.tracker is not None:
            running = self.tracker.start()
            return lambda z: running.step(z)[0]
        nothing = np.full(len(self.space.columns), np.nan)
        return lambda z: self.regressor.predict(z[None])[0] if np.isfinite(z).all() else nothing

    def _descriptor_of(self, mask: ArrayLike) -> Array:
        """Descriptor (d,) of a mask, NaN if it is blank."""
        descriptor = self._descriptor()
        if is_blank(mask):
            return np.full(len(descriptor.codebook_), np.nan)
        return descriptor.transform([mask])[0]

    def _describe(self, masks: str | Path | Masks, blank: str) -> DescribedMasks:
        """Describe the masks that have a foreground."""
        descriptor = self._descriptor()
        if isinstance(masks, str | Path):
            masks = MaskFiles(str(masks), blank).read()
        frames = [np.asarray(mask) for mask in masks]
        seen = visible(frames, blank)
        return DescribedMasks(frames, seen, descriptor.describe([frames[f] for f in seen]))

    def _tracker(self) -> Tracker:
        if self.tracker is None:
            raise InputError("this model has no tracker: train one with experiment=tracking")
        return self.tracker

    def _fitter(self) -> PoseFitter:
        if self.fitter is None:
            raise InputError("this model has no fitter: train one with fitting.enabled=true")
        return self.fitter

    def _descriptor(self) -> ShapeContextHistogram:
        if self.descriptor is None:
            raise InputError(
                "this model was trained on descriptors only and cannot describe masks: "
                "train one on motion"
            )
        return self.descriptor

    def save(self, path: str | Path) -> None:
        """Write the model to one ``.npz`` file, without pickled objects.

        Parameters
        ----------
        path : path

        See Also
        --------
        silpose.load : Loads it again.
        """
        header = {
            "regressor": type(self.regressor).__name__,
            "tracker": type(self.tracker).__name__ if self.tracker else None,
            "space": self.space.name,
            "frames_per_second": self.frames_per_second,
        }
        state: State = {}
        for part in PARTS:
            if (fitted := getattr(self, part)) is not None:
                state |= prefixed(part, fitted.to_arrays())
        write_model_file(path, header, state)
