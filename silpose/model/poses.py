"""Estimated poses, whatever they were estimated by."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Self

import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.core.pose_space import PoseSpace
from silpose.core.skeleton import standing_height
from silpose.core.types import Array
from silpose.fitting import DOUBTFUL, Fit
from silpose.motion import Motion, save_bvh
from silpose.silhouette.person import MaskFacts
from silpose.tracking import Track

_UNEVEN = 0.2  # share of an interval by which even times may be off
_SUCCESS = {"tracking": "tracking", "recovered": "tracking", "fitted": "fitted"}


@dataclass(frozen=True, eq=False)
class Poses:
    """Estimated poses of F frames: what everything that estimates poses returns.

    Attributes
    ----------
    x : ndarray, shape (F, D)
        Pose vectors; NaN where nothing was seen.
    space : PoseSpace
        Meaning of their columns.
    confidence : ndarray, shape (F,)
        Calibrated probability, 0 to 1, that the heading is within 45 degrees and the joints are
        within 120 millimetres; below 0.5 a pose is doubtful. 0 where there is no pose; NaN if
        the model was trained without a calibration.
    state : list of str
        State of each frame: ``estimated``, or why there is no pose (``blank`` and what else
        `MaskFacts` tells); of a track ``starting``, ``tracking``, ``lost`` or ``recovered``; of a
        fit ``fitted``, ``poor`` or ``blank``.
    time : ndarray, shape (F,)
        Seconds, increasing.
    iou : ndarray, shape (F,), or None, default=None
        Overlap of the fitted body's silhouette and the mask, where the body was fitted.
    facts : MaskFacts or None, default=None
        What was seen in each mask; None where poses were estimated from descriptors.
    track : Track or None, default=None
        Where poses were tracked, the track at the tracker's own rate, with beliefs or modes.
    fit : Fit or None, default=None
        Where the body was fitted, the fit: covariances, and where the camera sees which body.
    """

    x: Array
    space: PoseSpace
    confidence: Array
    state: list[str]
    time: Array
    iou: Array | None = None
    facts: MaskFacts | None = None
    track: Track | None = None
    fit: Fit | None = None

    def __len__(self) -> int:
        return len(self.x)

    @property
    def joints(self) -> Array:
        """Joint positions, metres, root at the origin, shape (F, J, 3); NaN as in `x`."""
        joints = np.full((len(self), len(self.space.joint_names), 3), np.nan)
        joints[self.known] = self.space.joints(self.x[self.known])
        return joints

    @property
    def heading(self) -> Array:
        """Heading relative to the direction to the camera, degrees, shape (F,)."""
        return self.space.heading(self.x)

    @property
    def heading_norm(self) -> Array:
        """Norm of the estimated (cos, sin), shape (F,): lower for uncertain estimates."""
        return self.space.heading_norm(self.x)

    @property
    def known(self) -> NDArray[np.bool_]:
        """Frames with a pose, shape (F,)."""
        return np.asarray(np.isfinite(self.x).all(axis=1))

    @property
    def seen(self) -> NDArray[np.bool_]:
        """Frames in whose mask there was a person, shape (F,)."""
        return self.known if self.facts is None else self.facts.seen

    @property
    def doubtful(self) -> NDArray[np.bool_]:
        """Frames with a pose that is doubtful, shape (F,).

        Where nobody was seen, and a tracker only expects a pose, it is one of these.
        """
        return np.asarray(self.known & (self.confidence < DOUBTFUL))

    @property
    def frames_per_second(self) -> float:
        """Frames per second, by the usual interval of `time`; NaN of a single frame."""
        return float(1 / np.median(np.diff(self.time))) if len(self) > 1 else np.nan

    def summary(self) -> str:
        """Count what there is to know of the frames, in one line.

        Returns
        -------
        line : str
            As ``51 masks, 15 blank, 3 cut by the frame, 12 doubtful, tracking in 48``.
        """
        parts = [_counted(len(self), "mask"), _some(~self.seen, "blank")]
        if self.facts is not None:
            parts.append(_some(self.facts.cut, "cut by the frame"))
        if np.isnan(self.confidence).all():
            parts.append("confidence unknown")
        else:
            parts.append(f"{(self.doubtful & self.seen).sum()} doubtful")
        states = Counter(_SUCCESS[state] for state in self.state if state in _SUCCESS)
        parts += [f"{state} in {count}" for state, count in states.items()]
        return ", ".join(part for part in parts if part)

    @classmethod
    def concatenate(cls, parts: Sequence[Self]) -> Self:
        """Join poses of the same kind, such as all steps of a stream, one after the other.

        Parameters
        ----------
        parts : sequence of Poses
            At least one.

        Returns
        -------
        poses : Poses
            Without tracks and fits.

        Raises
        ------
        InputError
            If there is none.
        """
        if not parts:
            raise InputError("there are no poses to join: give one step of a stream or more")
        first = parts[0]
        facts = [part.facts for part in parts if part.facts is not None]
        return cls(
            np.concatenate([part.x for part in parts]),
            first.space,
            np.concatenate([part.confidence for part in parts]),
            [state for part in parts for state in part.state],
            np.concatenate([part.time for part in parts]),
            iou=_joined([part.iou for part in parts if part.iou is not None], len(parts)),
            facts=type(facts[0]).concatenate(facts) if len(facts) == len(parts) else None,
        )

    def save_bvh(
        self,
        file: str | Path,
        frames_per_second: float | None = None,
        *,
        path: Array | None = None,
        scale: float = 1.0,
    ) -> None:
        """Write the poses as BVH, by default standing on one spot.

        Parameters
        ----------
        file : path
        frames_per_second : float, optional
            Rate at which the frames follow each other in the file; by default that of their times,
            to which frames at uneven times are interpolated.
        path : ndarray, shape (F, 3), optional
            Places of the root, metres, +Y up.
        scale : float, default=1.0
            Size of the person over that of the skeleton.

        Raises
        ------
        InputError
            If poses are joint positions, which BVH does not hold, or a single frame has no rate.

        Notes
        -----
        A frame of NaN repeats the one before.
        """
        x, rate, root = self.x, frames_per_second, path
        if rate is None:
            if len(self) < 2:
                raise InputError("a single pose has no frame rate: give frames_per_second=15")
            rate = self.frames_per_second
            x = _evenly(self.x, self.time, rate)
            root = None if path is None else _evenly(path, self.time, rate)
        if root is None:
            root = np.zeros((len(x), 3))
            root[:, 1] = scale * standing_height(self.space.rotations(np.nan_to_num(x)))
        save_bvh(file, Motion("poses", "unknown", rate, self.space.angles(x), root), scale)


def _counted(count: int, word: str) -> str:
    return f"{count} {word}" + ("" if count == 1 else "s")


def _some(frames: NDArray[np.bool_], word: str) -> str:
    """Count frames; nothing where there are none."""
    return f"{frames.sum()} {word}" if frames.any() else ""


def _joined(parts: Sequence[Array], wanted: int) -> Array | None:
    return np.concatenate(parts) if len(parts) == wanted else None


def _evenly(x: Array, time: Array, rate: float) -> Array:
    """Interpolate rows (F, D) to even times, where they are not at even times already."""
    steps = (time - time[0]) * rate
    if np.abs(steps - np.arange(len(steps))).max() < _UNEVEN:
        return x
    known = np.isfinite(x).all(axis=1)
    if not known.any():
        return x
    wanted = np.arange(round(steps[-1]) + 1)
    columns = (np.interp(wanted, steps[known], column) for column in x[known].T)
    return np.stack(list(columns), axis=1)
