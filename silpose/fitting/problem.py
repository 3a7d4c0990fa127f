"""What a fitter solves for one take: its frames, their starts, and what is free to change."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy.linalg import block_diag

from silpose.core.parallel import parallel_map
from silpose.core.types import Array, Indices, Mask
from silpose.fitting.contour import Contour
from silpose.fitting.fit import FAR
from silpose.fitting.frame_fit import cost_of_turning, fit_frame
from silpose.fitting.geometry import Geometry
from silpose.fitting.matching import Matching
from silpose.fitting.modes import Modes, legs_swapped, most_likely_path, spread_around
from silpose.fitting.overlap import aligned
from silpose.fitting.parameters import ANGLES, ELEVATION, LOG_SCALE, difference
from silpose.fitting.prior import PosePrior
from silpose.fitting.take_fit import fit_take
from silpose.fitting.view import View
from silpose.fitting.working_size import WorkingSize

KNOWN = 1e12
"""Precision of what is not to change."""
SHIFT_DEVIATION = 0.05
"""Standard deviation of a frame's image shift where the camera is not known, in image heights."""
INDEPENDENT_FRAMES = 5
"""Frames of a take whose misfits count as independent for what all frames share."""

End = tuple[Array, Array, float]
"""Parameters (P,), Hessian (P, P) and cost at the end of a fit."""

_UNLIKE_THE_REST = 0.7  # share of the usual overlap below which a frame is no evidence
_UNSEEN = Contour(np.empty((0, 2)), np.empty((0, 2)))


@dataclass(frozen=True, eq=False)
class Problem:
    """One take to be fitted.

    Attributes
    ----------
    geometry : Geometry
    working : WorkingSize
        Of `masks`.
    camera_view : View
        At the camera's own size.
    matching : Matching
    prior : PosePrior
    free : ndarray, shape (14,) or (0,)
        Precision of image shift, log scale, elevation and shape; empty if all are known.
    starts : ndarray, shape (F, S, P)
        Parameters to start each frame from, the first the prior's mean; NaN is none.
    roots : ndarray, shape (F, 3)
    masks : sequence of ndarray, each (H, W)
        At the working size.
    contours : sequence of Contour
        Those of the masks.
    frames : ndarray of int
        Those that have a contour and a start.
    iterations : int
    """

    geometry: Geometry
    working: WorkingSize
    camera_view: View
    matching: Matching
    prior: PosePrior
    free: Array
    starts: Array
    roots: Array
    masks: Sequence[Mask]
    contours: Sequence[Contour]
    frames: Indices
    iterations: int

    @property
    def view(self) -> View:
        """The camera at the working size."""
        return self.working.view(self.camera_view)

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
        return parallel_map(self._modes, self.frames.tolist(), prefer="threads")

    @cached_property
    def _precision(self) -> Array:
        """Of the prior of one frame's parameters."""
        own = self.free.copy()
        own[ELEVATION - ANGLES :] = KNOWN  # what all frames share is told by all of them only
        precision: Array = block_diag(self.prior.precision, np.diag(own))
        return precision

    def costs_of_turning(self, parameters: Array) -> Array:
        """How much worse each frame is explained by its body (n, P) turned around, (n,)."""
        mean = np.concatenate([self._means[:, :ANGLES], parameters[:, ANGLES:]], axis=1)
        precision, iterations = self._precision, max(1, self.iterations // 2)

        def cost(own: Array, expected: Array, frame: int) -> float:
            return cost_of_turning(
                own, expected, precision, self.roots[frame], self.contours[frame], self.geometry,
                self.view, self.matching, iterations,
            )  # fmt: skip

        frames = list(zip(parameters, mean, self.frames, strict=True))
        return np.array(parallel_map(lambda frame: cost(*frame), frames, prefer="threads"))

    def path_through(self, modes: Sequence[Modes], step_seconds: float) -> tuple[Array, Array]:
        """Follow the most likely path through the modes of the frames.

        Returns
        -------
        parameters : ndarray, shape (n, 68)
        covariance : ndarray, shape (n, 54, 54)
            Of their angles, radians²; that there are other modes adds to it.
        """
        path = most_likely_path(
            [m.parameters for m in modes], [m.costs for m in modes],
            self.prior.change_within(step_seconds), self.prior.bend_within(step_seconds),
        )  # fmt: skip
        parameters = np.stack([m.parameters[k] for m, k in zip(modes, path, strict=True)])
        hessians = np.stack([m.hessians[k] for m, k in zip(modes, path, strict=True)])
        spread = np.stack([spread_around(m, k) for m, k in zip(modes, path, strict=True)])
        return parameters, np.linalg.inv(hessians)[:, :ANGLES, :ANGLES] + spread

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
            of = self.roots[frame], self.geometry, self.camera_view
            iou[k] = self.working.overlap(self.masks[frame], own, *of)
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

    def end(self, frame: int, start: Array) -> End:
        """Fit one frame from one start (P,): parameters, their Hessian, and their cost."""
        parameters, hessian, cost = fit_frame(
            start, self.starts[frame, 0], self._precision, self.roots[frame], self.contours[frame],
            self.geometry, self.view, self.matching, self.iterations,
        )  # fmt: skip
        return parameters, hessian, float(cost)

    def _modes(self, frame: int) -> Modes:
        """Where the starts of a frame lead, and the best of these with its legs swapped."""
        starts = self.starts[frame]
        ends = [self.end(frame, start) for start in starts[np.isfinite(starts[:, 0])]]
        if len(starts) > 1:
            ends.append(self.end(frame, legs_swapped(min(ends, key=lambda e: e[2])[0])))
        return Modes.of(ends)

    def deviations(self, parameters: Array) -> Array:
        """Root mean square of each frame's deviation from the estimate, as `state_of` takes it."""
        off = np.stack([difference(p, m) for p, m in zip(parameters, self._means, strict=True)])
        covariance = np.deg2rad(np.deg2rad(self.prior.covariance[1:, 1:]))
        angles = off[:, 1:ANGLES]
        squared = (angles * np.linalg.solve(covariance, angles.T).T).sum(axis=1)
        deviations: Array = np.sqrt(squared / (ANGLES - 1))
        return deviations
