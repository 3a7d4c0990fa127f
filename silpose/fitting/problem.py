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
from silpose.fitting.frame_fit import Gaussian, cost_of_turning, fit_starts
from silpose.fitting.geometry import Geometry
from silpose.fitting.leg_motion import LegMotion
from silpose.fitting.leg_path import told_apart
from silpose.fitting.likelihood import Observation, misfit_of
from silpose.fitting.matching import Matching
from silpose.fitting.modes import Modes, legs_swapped, path_of_take, spread_around
from silpose.fitting.overlap import aligned
from silpose.fitting.parameters import (
    ANGLES,
    ELEVATION,
    LOG_SCALE,
    PARAMETERS,
    difference,
    seen_by,
    shaped_by,
)
from silpose.fitting.prior import CONTOUR_SECONDS, PosePrior, news
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
    starts : ndarray, shape (F, S, 57) or (F, S, 54)
        Parameters of a frame's own to start from, the first the prior's mean; NaN is none.
    roots : ndarray, shape (F, 3)
    masks : sequence of ndarray, each (H, W)
        At the working size.
    contours : sequence of Contour
        Those of the masks.
    frames : ndarray of int
        Those that have a contour and a start.
    iterations : int
    leg_motion : LegMotion or None, default=None
        How legs move on, if that is known.
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
    leg_motion: LegMotion | None = None

    @property
    def view(self) -> View:
        """The camera at the working size."""
        return self.working.view(self.camera_view)

    def observation(self, frame: int) -> Observation:
        """Tell what the body is to explain in one frame."""
        of = self.geometry, self.view, self.matching
        return Observation(self.contours[frame], self.roots[frame], *of)

    def with_aligned_starts(self) -> Problem:
        """Place the body where the contours are, where the camera is not known.

        The image's scale is one for all frames: the median of what their starts need.
        """
        starts, seen = self.starts.copy(), (self.geometry, self.view)
        for frame in self.frames:
            for start in starts[frame]:
                if np.isfinite(start[0]):
                    start[:] = aligned(start, self.roots[frame], self.contours[frame], *seen)
        starts[..., LOG_SCALE] = np.median(starts[self.frames, 0, LOG_SCALE])
        return replace(self, starts=starts)

    def some_frames(self, count: int) -> Problem:
        """Leave out all but some frames, spread over the take."""
        places = np.linspace(0, len(self.frames) - 1, min(count, len(self.frames)))
        return replace(self, frames=self.frames[np.unique(places.round().astype(int))])

    def complete(self, parameters: Array) -> Array:
        """Append the expected elevation and shape to parameters (n, 57); if known nothing."""
        if len(self.free) == 0:
            return parameters
        return np.pad(parameters, [(0, 0), (0, PARAMETERS - ELEVATION)])

    def modes(self) -> list[Modes]:
        """Fit every frame of `frames` by itself."""
        return parallel_map(self._modes, list(self.frames), prefer="threads")

    @cached_property
    def _precision(self) -> Array:
        """Of the prior of one frame's parameters."""
        own = self.free[: ELEVATION - ANGLES]  # what all frames share is told by all of them only
        precision: Array = block_diag(self.prior.precision, np.diag(own))
        return precision

    def costs_of_turning(self, parameters: Array) -> Array:
        """How much worse each frame is explained by its body (n, P) turned around, (n,)."""
        geometry, view = self.geometry, self.view
        if len(self.free):
            shared = np.concatenate([np.zeros(ELEVATION), parameters[0, ELEVATION:]])
            geometry, view = shaped_by(shared, geometry), seen_by(shared, view)
        parameters = np.ascontiguousarray(parameters[:, :ELEVATION])
        mean = np.concatenate([self._means[:, :ANGLES], parameters[:, ANGLES:]], axis=1)
        precision, iterations = self._precision, max(1, self.iterations // 2)

        def cost(own: Array, expected: Array, frame: int) -> float:
            seen = self.observation(frame)._replace(geometry=geometry, view=view)
            around = Gaussian(expected, precision)
            return cost_of_turning(own, misfit_of(own, seen), around, seen, iterations)

        frames = list(zip(parameters, mean, self.frames, strict=True))
        return np.array(parallel_map(lambda frame: cost(*frame), frames, prefer="threads"))

    def path_through(self, modes: Sequence[Modes], step_seconds: float) -> tuple[Array, Array]:
        """Follow the most likely path through the modes of the frames.

        Returns
        -------
        parameters : ndarray, shape (n, 57) or (n, 54)
        covariance : ndarray, shape (n, 54, 54)
            Of their angles, radians²; that there are other modes adds to it.
        """
        share = self._evidence_share(modes, step_seconds)
        costs = [share * m.costs for m in modes]
        path = path_of_take([m.parameters for m in modes], costs, self.prior, step_seconds)
        if self.leg_motion is not None:
            modes, path = told_apart(modes, path, self.leg_motion, self.prior, share, step_seconds)
        parameters = np.stack([m.parameters[k] for m, k in zip(modes, path, strict=True)])
        hessians = np.stack([m.hessians[k] for m, k in zip(modes, path, strict=True)])
        spread = np.stack([spread_around(m, k) for m, k in zip(modes, path, strict=True)])
        return parameters, np.linalg.inv(hessians)[:, :ANGLES, :ANGLES] + spread

    def _evidence_share(self, modes: Sequence[Modes], step_seconds: float) -> float:
        """How much a frame's cost counts beside how poses change.

        Contours of following frames err alike; and where no pose explains them to the pixel, as
        through clothes, what they prefer is the less certain.
        """
        usual = float(np.median([m.costs[0] for m in modes]))
        expected = 2 * self.matching.independent_points
        return news(step_seconds, CONTOUR_SECONDS) * min(1.0, expected / max(usual, 1.0))

    def together(self, parameters: Array, step_seconds: float) -> tuple[Array, Array]:
        """Fit all frames as one take, from parameters (n, 57) or (n, 54) of its frames.

        A frame whose body and mask overlap far less than those of most, or only in a pose far from
        the estimate, is no evidence: there, the frames before and after decide.
        """
        start = self.complete(parameters)
        means = np.zeros_like(start)
        means[:, : parameters.shape[1]] = self._means
        means[:, LOG_SCALE:ELEVATION] = np.median(parameters[:, LOG_SCALE:ELEVATION], axis=0)
        iou = self.overlaps(start)
        near = self.deviations(parameters) <= FAR
        trusted = near & (iou >= _UNLIKE_THE_REST * np.median(iou))
        seen = [
            self.observation(f) if good else self.observation(f)._replace(contour=_UNSEEN)
            for f, good in zip(self.frames, trusted, strict=True)
        ]
        return fit_take(
            start, means, self._shared_free, self.prior, step_seconds, seen,
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

    def ends(self, frame: int, starts: Array, cheapest: float = np.inf) -> list[End]:
        """Fit one frame from starts (S, P), of which those that lead nowhere are left out."""
        prior = Gaussian(self.starts[frame, 0], self._precision)
        parts = fit_starts(starts, prior, self.observation(frame), self.iterations, cheapest)
        ends = [(*end, float(cost)) for *end, cost in zip(*parts, strict=True)]
        return [end for end in ends if not np.isnan(end[2])]

    def _modes(self, frame: int) -> Modes:
        """Where the starts of a frame lead, and the best of these with its legs swapped."""
        starts = self.starts[frame]
        ends = self.ends(frame, starts[np.isfinite(starts[:, 0])])
        if len(starts) > 1:
            best = min(ends, key=lambda end: end[2])[0]
            # However much it costs: a path that lacks it in one frame has to swap legs twice.
            ends += self.ends(frame, legs_swapped(best)[None])
        return Modes.of(ends)

    def deviations(self, parameters: Array) -> Array:
        """Root mean square of each frame's deviation from the estimate, as `state_of` takes it."""
        pairs = zip(parameters[:, :ANGLES], self._means[:, :ANGLES], strict=True)
        angles = np.stack([difference(own, mean) for own, mean in pairs])[:, 1:]
        covariance = np.deg2rad(np.deg2rad(self.prior.covariance[1:, 1:]))
        squared = (angles * np.linalg.solve(covariance, angles.T).T).sum(axis=1)
        deviations: Array = np.sqrt(squared / (ANGLES - 1))
        return deviations
