"""`PoseModel`: fitted descriptor, regressor, tracker and fitter, from masks to poses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.core.errors import InputError
from silpose.core.pose_space import PoseSpace
from silpose.core.serialisation import State, prefixed
from silpose.core.types import Array
from silpose.descriptor import ShapeContextHistogram
from silpose.model.answers import check_rate, estimated, fitted, tracked
from silpose.model.confidence import Confidence
from silpose.model.described_masks import describe_masks, mask_options, spread
from silpose.model.model_file import write_model_file
from silpose.model.pose_fitter import PoseFitter
from silpose.model.pose_stream import PoseStream
from silpose.model.poses import Poses
from silpose.model.prediction_details import PredictionDetails
from silpose.regression import Regressor
from silpose.silhouette.masks import read_masks
from silpose.tracking import Tracker

Masks = NDArray[Any] | Sequence[ArrayLike]

PARTS = ("descriptor", "regressor", "tracker", "fitter", "confidence")
"""Parts of a model, by which its file names their arrays."""


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
    confidence : Confidence or None
        None for a model that was trained without a calibration.

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
    confidence: Confidence | None = None

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
        masks: object,
        blank: str = "error",
        *,
        fit: bool = False,
        frames_per_second: float | None = None,
        **options: Any,
    ) -> Poses:
        """Estimate the pose behind each mask.

        Parameters
        ----------
        masks : path, array, list, iterable, or PredictionDetails
            Masks of any origin, as `silpose.silhouette.masks.read_masks` takes them; or what
            `explain` returned of them.
        blank : {"error", "nan"}, default="error"
            Whether a mask without foreground is an error, or gives a row of NaN.
        fit : bool, default=False
            Whether to fit the body to the masks, which are consecutive frames then; the poses
            have an overlap.
        frames_per_second : float, optional
            Frame rate of the masks; by default the source's own, or else the model's.
        **options
            Further parameters of `silpose.silhouette.masks.MaskSource`, such as ``person="left"``.

        Returns
        -------
        poses : Poses

        Raises
        ------
        InputError
            If the masks cannot be read, one of them is blank, or several people are seen and none
            is chosen; if the model was trained on descriptors only, or without a fitter.
        """
        fitter = self._fitter() if fit else None  # before time is spent on masks
        details = self.explain(masks, blank, frames_per_second=frames_per_second, **options)
        return fitted(self, fitter, details) if fitter else estimated(self, details)

    def explain(
        self,
        masks: object,
        blank: str = "error",
        *,
        frames_per_second: float | None = None,
        **options: Any,
    ) -> PredictionDetails:
        """Estimate poses as `predict` does, with all intermediate results."""
        own = mask_options(blank, frames_per_second, options)
        if isinstance(masks, PredictionDetails):
            return replace(masks, frames_per_second=frames_per_second or masks.frames_per_second)
        described = describe_masks(self._descriptor(), masks, own)
        sequence, z, seen = described.sequence, described.z, described.facts.seen
        estimates = self.explain_descriptors(z[seen])
        return PredictionDetails(
            sequence.masks, described.points, described.nearest, z,
            spread(estimates.activations, seen), spread(estimates.x, seen), described.facts,
            sequence.names, sequence.source, frames_per_second or sequence.frames_per_second,
        )  # fmt: skip

    def explain_descriptors(self, z: Array) -> PredictionDetails:
        """Estimate poses from descriptors ``z (F, d)``, without masks."""
        x, activations = self.regressor.predict_with_activations(z)
        return PredictionDetails([], [], [], z, activations, x)

    def track(
        self,
        masks: object,
        lag: int = 0,
        frames_per_second: float | None = None,
        *,
        time: ArrayLike | None = None,
        **options: Any,
    ) -> Poses:
        """Track a person through masks, of which some may be blank.

        Parameters
        ----------
        masks : path, array, list, iterable, or PredictionDetails
            As of `predict`.
        lag : int, default=0
            Number of later masks that each estimate may wait for.
        frames_per_second : float, optional
            Frame rate of the masks, whichever it is; needed if the source has none of its own.
        time : array-like, shape (F,), optional
            Seconds of each mask instead, if they do not follow each other evenly.
        **options
            As of `predict`.

        Returns
        -------
        poses : Poses
            One for each mask, at its time.

        Raises
        ------
        InputError
            If the model has no tracker; if neither rate nor times are known; or as of `predict`.
        """
        tracker = self._tracker()
        own = mask_options("nan", frames_per_second, options)
        if not isinstance(masks, PredictionDetails):  # before time is spent on describing them
            masks = read_masks(masks, own)
            if time is None:
                check_rate(
                    frames_per_second or masks.frames_per_second,
                    masks.source,
                    self.frames_per_second,
                )
        details = self.explain(masks, "nan", frames_per_second=frames_per_second, **options)
        return tracked(self, tracker, details, lag, time)

    def stream(
        self, *, fit: bool = False, frames_per_second: float | None = None, **options: Any
    ) -> PoseStream:
        """Start tracking live.

        Parameters
        ----------
        fit : bool, default=False
            Whether to fit the body to each mask, from the tracker's pose if the model has a
            tracker, and from the regressor's otherwise.
        frames_per_second : float, optional
            Rate of masks that come without a time; by default the model's.
        **options
            As of `predict`.

        Returns
        -------
        stream : PoseStream
            ``stream.step(mask)`` or ``stream.step(mask, time)`` answers with `Poses` of one frame.
        """
        self._descriptor()
        if not fit:
            self._tracker()
        fitter = self._fitter() if fit else None
        return PoseStream(self, fitter, frames_per_second, mask_options("nan", None, options))

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
