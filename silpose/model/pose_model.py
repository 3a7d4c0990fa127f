"""`PoseModel`: fitted descriptor, regressor and tracker, from masks to poses."""

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
from silpose.core.types import Array, Indices
from silpose.descriptor import Description, ShapeContextHistogram
from silpose.model.model_file import write_model_file
from silpose.model.poses import Poses, PredictionDetails
from silpose.regression import Regressor
from silpose.silhouette import MaskFiles, is_blank, visible
from silpose.tracking import Track, Tracker

Masks = NDArray[Any] | Sequence[ArrayLike]


@dataclass(frozen=True)
class _DescribedMasks:
    """Masks, which of them have a foreground, and the descriptions of these."""

    masks: list[NDArray[Any]]
    visible: Indices
    descriptions: list[Description]

    @property
    def z(self) -> Array:
        """Descriptors, shape (F, d); NaN for a blank mask."""
        return self.spread(np.stack([description.z for description in self.descriptions]))

    def spread(self, rows: Array) -> Array:
        """Put a row of each visible mask (V, d) at its frame (F, d), and NaN elsewhere."""
        spread = np.full((len(self.masks), rows.shape[1]), np.nan)
        spread[self.visible] = rows
        return spread


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

    See Also
    --------
    silpose.load : Loads a saved model.
    """

    descriptor: ShapeContextHistogram | None
    regressor: Regressor
    space: PoseSpace
    frames_per_second: float
    tracker: Tracker | None = None

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

    def predict(self, masks: str | Path | Masks, blank: str = "error") -> Poses:
        """Estimate the pose behind each mask.

        Parameters
        ----------
        masks : array-like, shape (F, H, W), list of arrays (H, W), or path of a folder or video
        blank : {"error", "nan"}, default="error"
            Whether a mask without foreground is an error, or gives a row of NaN.

        Returns
        -------
        poses : Poses

        Raises
        ------
        InputError
            If a mask is blank, or if the model was trained on descriptors only.
        """
        return Poses(self.explain(masks, blank).x, self.space)

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

    def stream(self) -> Callable[[ArrayLike], tuple[Array, str]]:
        """Start tracking live.

        Returns
        -------
        step : callable
            From the next mask (H, W), blank or not, to its pose (D,) and the track's state.
        """
        running, descriptor = self._tracker().start(), self._descriptor()
        nothing = np.full(len(descriptor.codebook_), np.nan)

        def step(mask: ArrayLike) -> tuple[Array, str]:
            return running.step(nothing if is_blank(mask) else descriptor.transform([mask])[0])

        return step

    def _describe(self, masks: str | Path | Masks, blank: str) -> _DescribedMasks:
        """Describe the masks that have a foreground."""
        descriptor = self._descriptor()
        if isinstance(masks, str | Path):
            masks = MaskFiles(str(masks), blank).read()
        frames = [np.asarray(mask) for mask in masks]
        seen = visible(frames, blank)
        return _DescribedMasks(frames, seen, descriptor.describe([frames[f] for f in seen]))

    def _tracker(self) -> Tracker:
        if self.tracker is None:
            raise InputError("this model has no tracker: train one with experiment=tracking")
        return self.tracker

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
        for part in ("descriptor", "regressor", "tracker"):
            if (fitted := getattr(self, part)) is not None:
                state |= prefixed(part, fitted.to_arrays())
        write_model_file(path, header, state)
