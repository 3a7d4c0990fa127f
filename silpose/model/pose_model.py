"""`PoseModel`: fitted descriptor, regressor and tracker, from masks to poses, saved to one file."""

from __future__ import annotations

import json
import zipfile
from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.core.errors import InputError
from silpose.core.pose_space import SPACES, AnglePoseSpace, PoseSpace
from silpose.core.skeleton import standing_height
from silpose.descriptor import Description, ShapeContextHistogram
from silpose.motion import Motion, save_bvh
from silpose.regression import REGRESSORS, Regressor
from silpose.silhouette import read_masks
from silpose.tracking import TRACKERS, AnyTracker, ManyTracks, Track

Array = NDArray[np.float64]
Masks = NDArray[Any] | Sequence[ArrayLike]

FORMAT = 5


@dataclass(frozen=True)
class Poses:
    """Estimated poses of F frames.

    Attributes
    ----------
    x : ndarray, shape (F, D)
        Pose vectors.
    space : PoseSpace
        Meaning of their columns.
    """

    x: Array
    space: PoseSpace

    def __len__(self) -> int:
        return len(self.x)

    @property
    def joints(self) -> Array:
        """Joint positions, metres, root at the origin, shape (F, J, 3); NaN without an answer."""
        known = np.isfinite(self.x).all(axis=1)
        joints = np.full((len(self), len(self.space.joint_names), 3), np.nan)
        joints[known] = self.space.joints(self.x[known])
        return joints

    @property
    def heading(self) -> Array:
        """Heading relative to the direction to the camera, degrees, shape (F,)."""
        return self.space.heading(self.x)

    @property
    def heading_norm(self) -> Array:
        """Norm of the estimated (cos, sin): below 1 where the estimate doubts, shape (F,)."""
        return self.space.heading_norm(self.x)

    def save_bvh(self, file: str | Path, frames_per_second: float) -> None:
        """Write the poses as BVH, standing on one spot; a frame of NaN repeats the one before."""
        if not isinstance(self.space, AnglePoseSpace):
            raise InputError("these poses are joint positions, which BVH does not hold")
        known = np.nan_to_num(self.x)
        root = np.zeros((len(self), 3))
        root[:, 1] = standing_height(self.space.rotations(known))
        angles = self.space.angles(self.x)
        save_bvh(file, Motion("poses", "unknown", frames_per_second, angles, root))


@dataclass(frozen=True)
class PredictionDetails:
    """What a model saw of F masks, and what it made of them.

    Attributes
    ----------
    masks : list of ndarray, each (H, W)
        Empty, as the points, where descriptors are all there is.
    points : list of ndarray, each (P, 2)
        Edge points, pixels; none for a blank mask.
    nearest : list of ndarray of int, each (P,)
        The codebook centre nearest to each.
    z : ndarray, shape (F, d)
        Descriptors; NaN for a blank mask, as the following.
    activations : ndarray, shape (F, k)
        Of the basis functions that are kept.
    x : ndarray, shape (F, D)
        Estimated poses.
    """

    masks: list[NDArray[np.uint8]]
    points: list[NDArray[np.int32]]
    nearest: list[NDArray[np.int32]]
    z: Array
    activations: Array
    x: Array


@dataclass
class PoseModel:
    """From masks to poses.

    Attributes
    ----------
    descriptor : ShapeContextHistogram or None
        None for a model that was trained on descriptors of unknown origin: it sees no masks.
    regressor : Regressor
    space : PoseSpace
    frames_per_second : float
        Of the motion that it was trained on.
    tracker : BeliefTracker or MultipleHypothesisTracker or None
        None for a model that sees each image on its own.
    """

    descriptor: ShapeContextHistogram | None
    regressor: Regressor
    space: PoseSpace
    frames_per_second: float
    tracker: AnyTracker | None = None

    def fit(self, masks: Masks, x: ArrayLike) -> PoseModel:
        """Learn the codebook and the regression.

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
        blank : {"error", "nan"}
            What a mask without foreground gives: an error, or a row of NaN.
        """
        return Poses(self.explain(masks, blank).x, self.space)

    def explain(self, masks: str | Path | Masks, blank: str = "error") -> PredictionDetails:
        """Estimate poses as `predict` does, and keep every step."""
        frames, seen, described = self._describe(masks, blank)
        z = np.stack([d.z for d in described])
        points = [np.empty((0, 2), np.int32)] * len(frames)
        nearest = [np.empty(0, np.int32)] * len(frames)
        for frame, description in zip(seen, described, strict=True):
            points[frame], nearest[frame] = description.points, description.nearest
        seen_only = self.explain_descriptors(z)
        return PredictionDetails(
            frames,
            points,
            nearest,
            *(_spread(rows, seen, len(frames)) for rows in (z, seen_only.activations, seen_only.x)),
        )

    def explain_descriptors(self, z: Array) -> PredictionDetails:
        """Estimate poses from descriptors ``z (F, d)``, without masks."""
        return PredictionDetails(
            [], [], [], z, self.regressor.activations(z), self.regressor.predict(z)
        )

    def track(
        self, masks: str | Path | Masks, lag: int = 0, frames_per_second: float | None = None
    ) -> Track | ManyTracks:
        """Track a person through masks; a blank one is a frame without anything to see.

        Parameters
        ----------
        masks
            As for `predict`.
        lag : int
            How many later frames each estimate may wait for.
        frames_per_second : float, optional
            Of the masks, if known: refused if the tracker was trained at another rate.
        """
        tracker = self._tracker()
        frames, seen, described = self._describe(masks, blank="nan")
        z = _spread(np.stack([d.z for d in described]), seen, len(frames))
        return tracker.track(z, lag=lag, frames_per_second=frames_per_second)

    def stream(self) -> Callable[[ArrayLike], tuple[Array, str]]:
        """Start tracking live: a function from each next mask to its pose (D,) and state."""
        tracker, descriptor = copy(self._tracker()).start(), self._descriptor()
        blank = np.full(len(descriptor.codebook_), np.nan)

        def step(mask: ArrayLike) -> tuple[Array, str]:
            seen = np.any(mask)
            return tracker.step(descriptor.transform([mask])[0] if seen else blank)

        return step

    def _describe(
        self, masks: str | Path | Masks, blank: str
    ) -> tuple[list[NDArray[Any]], NDArray[np.intp], list[Description]]:
        """Give masks, which of them are described, and their descriptions."""
        if isinstance(masks, str | Path):
            masks = read_masks(masks, blank)
        frames = [np.asarray(mask) for mask in masks]
        if blank == "error":
            seen = np.arange(len(frames))  # the descriptor names a blank one
        elif blank == "nan":
            seen = np.flatnonzero([np.any(mask) for mask in frames])
        else:
            raise InputError(f"blank is 'error' or 'nan', not '{blank}'")
        return frames, seen, self._descriptor().describe([frames[f] for f in seen])

    def _tracker(self) -> AnyTracker:
        if self.tracker is None:
            raise InputError("this model has no tracker: train one with experiment=tracking")
        return self.tracker

    def _descriptor(self) -> ShapeContextHistogram:
        if self.descriptor is None:
            raise InputError("this model was trained on descriptors only: it cannot look at masks")
        return self.descriptor

    def save(self, path: str | Path) -> None:
        """Write the model as an ``.npz`` without pickled objects."""
        header = {
            "format": FORMAT,
            "silpose": version("silpose"),
            "regressor": type(self.regressor).__name__,
            "tracker": type(self.tracker).__name__,
            "space": self.space.name,
            "frames_per_second": self.frames_per_second,
        }
        arrays = {"header": np.array(json.dumps(header))}
        for part in ("descriptor", "regressor", "tracker"):
            state = {} if getattr(self, part) is None else getattr(self, part).to_arrays()
            arrays |= {f"{part}.{name}": np.asarray(value) for name, value in state.items()}
        with Path(path).open("wb") as file:  # savez would append .npz to the name
            np.savez_compressed(file, **arrays)  # type: ignore[arg-type]

    @classmethod
    def load(cls, path: str | Path) -> PoseModel:
        """Read a saved model: an ``.npz``, or the folder of the run that holds it."""
        path = Path(path)
        if path.is_dir():
            path = path / "model.npz"
        if not path.is_file():
            raise InputError(f"there is no model '{path}': give a run's model.npz")
        try:
            with np.load(path, allow_pickle=False) as file:
                arrays: dict[str, Any] = dict(file)
            header = json.loads(str(arrays.pop("header")))
        except (ValueError, OSError, EOFError, KeyError, zipfile.BadZipFile) as error:
            raise InputError(f"'{path}' is no silpose model: give a run's model.npz") from error
        if header["format"] != FORMAT:
            raise InputError(
                f"'{path}' has format {header['format']} of silpose {header['silpose']}; "
                f"this version reads format {FORMAT}: train the model anew"
            )
        states: dict[str, dict[str, Any]] = {"descriptor": {}, "regressor": {}, "tracker": {}}
        for name, value in arrays.items():
            part, _, entry = name.partition(".")
            states[part][entry] = value
        return cls(
            ShapeContextHistogram.from_arrays(states["descriptor"])
            if states["descriptor"]
            else None,
            REGRESSORS[header["regressor"]].from_arrays(states["regressor"]),
            SPACES[header["space"]],
            header["frames_per_second"],
            TRACKERS[header["tracker"]].from_arrays(states["tracker"])
            if states["tracker"]
            else None,
        )


def _spread(rows: Array, frames: NDArray[np.intp], count: int) -> Array:
    """Put rows where their frames are, and NaN elsewhere."""
    spread = np.full((count, rows.shape[1]), np.nan)
    spread[frames] = rows
    return spread
