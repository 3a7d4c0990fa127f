"""What a fitter solves for one take: its frames, their starts, and what is free to change."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from scipy.linalg import block_diag

from silpose.core.parallel import parallel_map
from silpose.core.pose_space import ANGLES as SPACE
from silpose.core.types import Array, Indices, Mask
from silpose.fitting.contour import Contour
from silpose.fitting.fit import FAR, Fit, state_of
from silpose.fitting.frame_fit import fit_frame
from silpose.fitting.geometry import Geometry
from silpose.fitting.matching import Matching
from silpose.fitting.modes import Modes, distinct, legs_swapped, most_likely_path, weights_of
from silpose.fitting.overlap import aligned, overlap, silhouette_of
from silpose.fitting.parameters import (
    ANGLES,
    ELEVATION,
    LOG_SCALE,
    PARAMETERS,
    SHAPE,
    SHIFT_X,
    SHIFT_Y,
    difference,
)
from silpose.fitting.prior import PosePrior
from silpose.fitting.take_fit import fit_take
from silpose.fitting.view import View

KNOWN = 1e12
"""Precision of what is not to change."""
SHIFT_DEVIATION = 0.05
"""Standard deviation of a frame's image shift where the camera is not known, in image heights."""
INDEPENDENT_FRAMES = 5
"""Frames of a take whose misfits count as independent for what all frames share."""

_UNLIKE_THE_REST = 0.7  # share of the usual overlap below which a frame is no evidence
_UNSEEN = Contour(np.empty((0, 2)), np.empty((0, 2)))


@dataclass(frozen=True, eq=False)
class Problem:
    """One take to be fitted.

    Attributes
    ----------
    geometry : Geometry
    view : View
    matching : Matching
    prior : PosePrior
    free : ndarray, shape (14,) or (0,)
        Precision of image shift, log scale, elevation and shape; empty if all are known.
    starts : ndarray, shape (F, S, P)
        Parameters to start each frame from, the first the prior's mean; NaN is none.
    roots : ndarray, shape (F, 3)
    masks : sequence of ndarray, each (H, W)
    contours : sequence of Contour
        Those of the masks.
    frames : ndarray of int
        Those that have a contour and a start.
    iterations : int
    """

    geometry: Geometry
    view: View
    matching: Matching
    prior: PosePrior
    free: Array
    starts: Array
    roots: Array
    masks: Sequence[Mask]
    contours: Sequence[Contour]
    frames: Indices
    iterations: int

    def with_aligned_starts(self) -> Problem:
        """Place the body where the contours are, where the camera is not known.

        The image's scale is one for all frames: the median of what their starts need.
        """
        starts = self.starts.copy()
        for frame in self.frames:
            for start in starts[frame]:
                if np.isfinite(start[0]):
                    start[:] = self._align(start, frame)
        scale = np.median(starts[self.frames, 0, LOG_SCALE])
        for frame in self.frames:
            for start in starts[frame]:
                if np.isfinite(start[0]):
                    start[:] = self._align(start, frame)
                    start[LOG_SCALE] = scale
        return replace(self, starts=starts)

    def _align(self, start: Array, frame: int) -> Array:
        return aligned(start, self.roots[frame], self.contours[frame], self.geometry, self.view)

    def modes(self) -> list[Modes]:
        """Fit every frame of `frames` by itself, from all its starts."""
        own = self.free.copy()
        own[ELEVATION - ANGLES :] = KNOWN  # what all frames share is told by all of them only
        precision = block_diag(self.prior.precision, np.diag(own))
        return parallel_map(
            partial(self._modes, precision=precision), self.frames.tolist(), prefer="threads"
        )

    def path_through(self, modes: Sequence[Modes], step_seconds: float) -> tuple[Array, Array]:
        """Follow the most likely path through the modes of the frames.

        Returns
        -------
        parameters : ndarray, shape (n, 68)
        covariance : ndarray, shape (n, 54, 54)
            Of their angles, radians².
        """
        path = most_likely_path(
            [m.parameters for m in modes], [m.costs for m in modes],
            self.prior.change_within(step_seconds), self.prior.bend_within(step_seconds),
        )  # fmt: skip
        parameters = np.stack([m.parameters[k] for m, k in zip(modes, path, strict=True)])
        hessians = np.stack([m.hessians[k] for m, k in zip(modes, path, strict=True)])
        return parameters, np.linalg.inv(hessians)[:, :ANGLES, :ANGLES]

    def together(self, parameters: Array, step_seconds: float) -> tuple[Array, Array]:
        """Fit all frames as one take, from parameters (n, 68) of its frames.

        A frame whose body and mask overlap far less than those of most, or only in a pose far from
        the estimate, is no evidence: there, the frames before and after decide.
        """
        start = parameters.copy()
        start[:, ELEVATION:] = np.median(parameters[:, ELEVATION:], axis=0)
        means = self._means.copy()
        means[:, LOG_SCALE:ELEVATION] = np.median(parameters[:, LOG_SCALE:ELEVATION], axis=0)
        iou = self.overlaps(parameters)
        near = self.deviations(parameters) <= FAR
        trusted = near & (iou >= _UNLIKE_THE_REST * np.median(iou))
        contours = [
            self.contours[f] if good else _UNSEEN
            for f, good in zip(self.frames, trusted, strict=True)
        ]
        return fit_take(
            start, means, self._shared_free, self.prior, step_seconds,
            self.roots[self.frames], contours, self.geometry, self.view, self.matching,
            max(1, self.iterations // 2),
        )  # fmt: skip

    def overlaps(self, parameters: Array) -> Array:
        """Overlap of the body that parameters (n, P) describe with the mask of each frame."""
        iou = np.empty(len(parameters))
        for k, (own, frame) in enumerate(zip(parameters, self.frames, strict=True)):
            size, root = np.shape(self.masks[frame]), self.roots[frame]
            fitted = silhouette_of(own, root, self.geometry, self.view, *size)
            iou[k] = overlap(fitted, self.masks[frame])
        return iou

    @property
    def _shared_free(self) -> Array:
        """Precisions, those of shared parameters as if only every few frames were independent."""
        free = self.free.copy()
        free[ELEVATION - ANGLES :] *= max(1.0, len(self.frames) / INDEPENDENT_FRAMES)
        return free

    @property
    def _means(self) -> Array:
        return self.starts[self.frames, 0]

    def _modes(self, frame: int, precision: Array) -> Modes:
        """Where the starts of a frame lead, and the best of these with its legs swapped."""
        starts = self.starts[frame]

        def end(start: Array) -> tuple[Array, Array, float]:
            parameters, hessian, cost = fit_frame(
                start, starts[0], precision, self.roots[frame], self.contours[frame],
                self.geometry, self.view, self.matching, self.iterations,
            )  # fmt: skip
            return parameters, hessian, float(cost)

        ends = [end(start) for start in starts[np.isfinite(starts[:, 0])]]
        if len(starts) > 1:
            ends.append(end(legs_swapped(min(ends, key=lambda e: e[2])[0])))
        parameters, hessians, costs = (np.array(part) for part in zip(*ends, strict=True))
        kept = distinct(parameters, costs)
        return Modes(parameters[kept], hessians[kept], costs[kept])

    def deviations(self, parameters: Array) -> Array:
        """Root mean square of each frame's deviation from the estimate, as `state_of` takes it."""
        off = np.stack([difference(p, m) for p, m in zip(parameters, self._means, strict=True)])
        covariance = np.deg2rad(np.deg2rad(self.prior.covariance[1:, 1:]))
        angles = off[:, 1:ANGLES]
        squared = (angles * np.linalg.solve(covariance, angles.T).T).sum(axis=1)
        deviations: Array = np.sqrt(squared / (ANGLES - 1))
        return deviations

    def fit_of(self, parameters: Array, covariance: Array, modes: Sequence[Modes]) -> Fit:
        """Put the fitted frames where they belong, with the overlap of body and mask."""
        every = _complete(parameters)
        count, most = len(self.starts), max(len(m.costs) for m in modes)
        x, shift = np.full((count, ANGLES + 1), np.nan), np.full((count, 2), np.nan)
        scale = np.full(count, np.nan)
        spread, iou = np.full((count, ANGLES, ANGLES), np.nan), np.full(count, np.nan)
        poses, weights = np.full((count, most, ANGLES + 1), np.nan), np.zeros((count, most))
        x[self.frames], scale[self.frames] = _poses(every), np.exp(every[:, LOG_SCALE])
        shift[self.frames] = every[:, [SHIFT_X, SHIFT_Y]]
        spread[self.frames] = np.rad2deg(np.rad2deg(covariance))
        iou[self.frames] = self.overlaps(parameters)
        deviation = np.zeros(count)
        deviation[self.frames] = self.deviations(parameters)
        for frame, found in zip(self.frames, modes, strict=True):
            poses[frame, : len(found.costs)] = _poses(found.parameters)
            weights[frame, : len(found.costs)] = weights_of(found.costs)
        shared = np.median(every, axis=0)
        return Fit(
            x, spread, iou, [state_of(*of) for of in zip(iou, deviation, strict=True)], shift,
            scale,
            float(np.rad2deg(self.view.elevation + shared[ELEVATION])), shared[SHAPE:],
            poses, weights,
        )  # fmt: skip


def _complete(parameters: Array) -> Array:
    """All 68 parameters, 0 where they are known."""
    every = np.zeros((len(parameters), PARAMETERS))
    every[:, : parameters.shape[1]] = parameters
    return every


def _poses(parameters: Array) -> Array:
    return SPACE.from_angles(np.rad2deg(parameters[:, :ANGLES]))
