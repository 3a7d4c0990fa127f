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
from silpose.fitting.fit import Fit, state_of
from silpose.fitting.frame_fit import fit_frame
from silpose.fitting.geometry import Geometry
from silpose.fitting.likelihood import (
    ANGLES,
    ELEVATION,
    LOG_SCALE,
    PARAMETERS,
    SHAPE,
    SHIFT_X,
    SHIFT_Y,
    Matching,
)
from silpose.fitting.outline import View
from silpose.fitting.overlap import aligned, overlap, silhouette_of
from silpose.fitting.prior import PosePrior
from silpose.fitting.take_fit import fit_take, most_likely_path

KNOWN = 1e12
"""Precision of what is not to change."""
INDEPENDENT_FRAMES = 5
"""Frames of a take whose misfits count as independent for what all frames share."""


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
    contours : sequence of Contour
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

    def frame_by_frame(self, step_seconds: float) -> tuple[Array, Array]:
        """Fit every frame by itself, and follow the most likely path through the ends.

        Returns
        -------
        parameters : ndarray, shape (n, 68)
            Of the frames that can be fitted.
        covariance : ndarray, shape (n, 54, 54)
            Of their angles, radians².
        """
        own = self.free.copy()
        own[ELEVATION - ANGLES :] = KNOWN  # what all frames share is told by all of them only
        precision = block_diag(self.prior.precision, np.diag(own))
        ends = parallel_map(
            partial(self._modes, precision=precision), self.frames.tolist(), prefer="threads"
        )
        change = self.prior.change_within(step_seconds)
        path = most_likely_path([e[0] for e in ends], [e[2] for e in ends], change)
        parameters = np.stack([e[0][k] for e, k in zip(ends, path, strict=True)])
        hessians = np.stack([e[1][k] for e, k in zip(ends, path, strict=True)])
        return parameters, np.linalg.inv(hessians)[:, :ANGLES, :ANGLES]

    def together(self, parameters: Array, step_seconds: float) -> tuple[Array, Array]:
        """Fit all frames as one take, from parameters (n, 68) of its frames."""
        start = parameters.copy()
        start[:, LOG_SCALE:] = np.median(parameters[:, LOG_SCALE:], axis=0)
        return fit_take(
            start, self._means, self._shared_free, self.prior, step_seconds,
            self.roots[self.frames], [self.contours[f] for f in self.frames], self.geometry,
            self.view, self.matching,
            max(1, self.iterations // 2),
        )  # fmt: skip

    @property
    def _shared_free(self) -> Array:
        """Precisions, those of shared parameters as if only every few frames were independent."""
        free = self.free.copy()
        free[LOG_SCALE - ANGLES :] *= max(1.0, len(self.frames) / INDEPENDENT_FRAMES)
        return free

    @property
    def _means(self) -> Array:
        return self.starts[self.frames, 0]

    def _modes(self, frame: int, precision: Array) -> tuple[Array, Array, Array]:
        """Parameters (k, 68), Hessians and costs of a frame's ends, one for each start."""
        starts = self.starts[frame]
        ends = [
            fit_frame(
                start, starts[0], precision, self.roots[frame], self.contours[frame],
                self.geometry, self.view, self.matching, self.iterations,
            )
            for start in starts[np.isfinite(starts[:, 0])]
        ]  # fmt: skip
        parameters, hessians, costs = zip(*ends, strict=True)
        return np.stack(parameters), np.stack(hessians), np.array(costs)

    def fit_of(self, parameters: Array, covariance: Array, masks: Sequence[Mask]) -> Fit:
        """Put the fitted frames where they belong, with the overlap of body and mask."""
        every = np.zeros((len(parameters), PARAMETERS))
        every[:, : parameters.shape[1]] = parameters
        count = len(self.starts)
        x, shift = np.full((count, ANGLES + 1), np.nan), np.full((count, 2), np.nan)
        spread, iou = np.full((count, ANGLES, ANGLES), np.nan), np.full(count, np.nan)
        x[self.frames] = SPACE.from_angles(np.rad2deg(every[:, :ANGLES]))
        shift[self.frames] = every[:, [SHIFT_X, SHIFT_Y]]
        spread[self.frames] = np.rad2deg(np.rad2deg(covariance))
        for own, frame in zip(every, self.frames, strict=True):
            mask, root = masks[frame], self.roots[frame]
            fitted = silhouette_of(own, root, self.geometry, self.view, *np.shape(mask))
            iou[frame] = overlap(fitted, mask)
        shared = np.median(every, axis=0)
        return Fit(
            x, spread, iou, [state_of(value) for value in iou], shift,
            float(np.exp(shared[LOG_SCALE])),
            float(np.rad2deg(self.view.elevation + shared[ELEVATION])), shared[SHAPE:],
        )  # fmt: skip
