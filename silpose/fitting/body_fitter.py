"""The estimator: from masks and estimated poses to the poses that explain the masks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass, field, replace
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES as SPACE
from silpose.core.types import Array, Mask
from silpose.fitting.answer import answer_of
from silpose.fitting.carried import with_carried
from silpose.fitting.confidence import Confidence
from silpose.fitting.fit import Fit
from silpose.fitting.geometry import geometry_of
from silpose.fitting.leg_motion import LegMotion
from silpose.fitting.matching import Matching
from silpose.fitting.overlap import outline_error
from silpose.fitting.parameters import ANGLES, ELEVATION, PARAMETERS, SHAPE
from silpose.fitting.prior import PosePrior
from silpose.fitting.problem import KNOWN, SHIFT_DEVIATION, Problem
from silpose.fitting.view import View
from silpose.fitting.working_size import WorkingSize, expected_height, seen_height
from silpose.silhouette import Body, Camera

Knowledge = Literal["known", "estimated"]

# Standard deviations of what is not known: a frame's log scale, from where the take's frames have
# it, as the person comes nearer; elevation and shape.
_SCALE, _ELEVATION_DEG, _SHAPE = 0.03, 2.5, 0.7
_SOME = 16  # frames that tell whether clothes are worn
_LONG = 10.0  # seconds after which estimates err anew
_BARE = 0.5  # pixels that the outline is off up to which masks are those of a bare body


@dataclass(frozen=True, eq=False)
class BodyFitter:
    """Fits a body of rigid links to masks.

    Attributes
    ----------
    body : Body
        Of kind ``convex``. With an estimated shape, the one expected.
    camera : Camera
        With an estimated camera, the one expected; the image's shift, scale and elevation change.
    prior : PosePrior
        How the estimates err that the fit starts from.
    camera_is : {"known", "estimated"}, default="known"
    shape_is : {"known", "estimated"}, default="known"
    whole_take : bool, default=True
        Whether frames are fitted together, as a take in which poses follow each other.
    iterations : int, default=10
        Gauss-Newton steps of each frame and start.
    matching : Matching, default=Matching()
        How contours are compared; if the shape is estimated and no shape explains the masks as
        well as those of a bare body, with an allowance for clothes.
    confidence : Confidence, default=Confidence()
        How the probability that a pose is right is read from the evidence.
    leg_motion : LegMotion or None, default=None
        How legs move on, by which a take's fits tell left from right.
    """

    body: Body
    camera: Camera
    prior: PosePrior
    _: KW_ONLY
    camera_is: Knowledge = "known"
    shape_is: Knowledge = "known"
    whole_take: bool = True
    iterations: int = 10
    matching: Matching = field(default_factory=Matching)
    confidence: Confidence = field(default_factory=Confidence)
    leg_motion: LegMotion | None = None

    def fit(
        self,
        masks: Sequence[Mask],
        start: ArrayLike,
        *,
        others: ArrayLike | None = None,
        roots: ArrayLike | None = None,
        frames_per_second: float = 15.0,
    ) -> Fit:
        """Fit the body to masks.

        Parameters
        ----------
        masks : sequence of ndarray, each (H, W)
            Consecutive frames of one person, all of the camera's size; a blank one has nothing to
            fit to.
        start : array-like, shape (F, 55)
            Estimated poses, around which the prior is; NaN where there is none: then the first of
            the others takes its place.
        others : array-like, shape (F, S, 55), optional
            Further poses to start from, such as the modes of a mixture; NaN is none. The more
            probable end of all starts counts, and over a take the path of such ends.
        roots : array-like, shape (F, 3), optional
            Root relative to what the camera looks at, metres; at the origin by default.
        frames_per_second : float, default=15.0

        Returns
        -------
        fit : Fit
        """
        known = self.camera_is == self.shape_is == "known"
        starts = _parameters_of(start, others, 0 if known else ELEVATION - ANGLES)
        places = np.zeros((len(starts), 3)) if roots is None else np.asarray(roots, dtype=float)
        if not len(masks) == len(starts) == len(places):
            raise InputError(
                f"{len(masks)} masks, {len(starts)} starts and {len(places)} roots do not belong "
                "together: give one of each for every frame"
            )
        size = (self.camera.height, self.camera.width)
        if wrong := [np.shape(mask) for mask in masks if np.shape(mask) != size]:
            raise InputError(
                f"a mask has shape {wrong[0]} where the camera's is {size}: fit with "
                f"Camera(width={wrong[0][1]}, height={wrong[0][0]})"
            )
        working = self.working_size(masks)
        sized = [working.mask(mask) for mask in masks]
        contours = [working.contour(mask) for mask in sized]
        seen = np.array([len(c.pixels) > 0 for c in contours]) & np.isfinite(starts[:, 0, 0])
        if not seen.any():
            raise InputError("no frame has both a person and an estimated pose to start from")
        problem = Problem(
            geometry_of(self.body), working, self.view, self.matching, self.prior,
            self._free_at(working), starts, places, sized, contours, np.flatnonzero(seen),
            self.iterations, self.leg_motion,
        )  # fmt: skip
        if self.camera_is == "estimated":
            problem = problem.with_aligned_starts()
        if not known:
            problem = self._dressed(problem)
        return self._solve(problem, 1 / frames_per_second)

    def _dressed(self, problem: Problem) -> Problem:
        """Allow for clothes if, of some frames, no shape explains the masks without."""
        if self.shape_is == "known":
            return problem
        some = problem.some_frames(_SOME)
        own = np.stack([modes.parameters[0] for modes in some.modes()])
        found = some.together(own, _LONG)[0] if self.whole_take else some.complete(own)
        if _outline_error(some, found) > _BARE:
            return replace(problem, matching=self.matching.clothed())
        return problem

    def _solve(self, problem: Problem, step_seconds: float) -> Fit:
        modes = problem.modes()
        if self.whole_take:
            modes = with_carried(problem, modes)
        parameters, covariance = problem.path_through(modes, step_seconds)
        if self.whole_take:
            parameters, covariance = problem.together(parameters, step_seconds)
        else:
            parameters = problem.complete(parameters)
        return answer_of(problem, parameters, covariance, modes, self.confidence)

    @property
    def view(self) -> View:
        """The camera as the fit sees it."""
        camera = self.camera
        return View(
            camera.focal_pixels, float(np.deg2rad(camera.elevation)), camera.distance,
            (camera.width - 1) / 2, (camera.height - 1) / 2,
        )  # fmt: skip

    def working_size(self, masks: Sequence[Mask]) -> WorkingSize:
        """Size at which masks are compared: by the camera, or by what they show if it is free."""
        tall = expected_height(self.camera)
        if self.camera_is == "estimated":
            tall = seen_height(masks) or tall
        return WorkingSize.for_person(self.camera, tall)

    def _free_at(self, working: WorkingSize) -> Array:
        """Precision of image shift, log scale, elevation and shape; empty if all are known."""
        if self.camera_is == self.shape_is == "known":
            return np.empty(0)
        free = np.full(PARAMETERS - ANGLES, KNOWN)
        if self.camera_is == "estimated":
            shift = SHIFT_DEVIATION * working.factor * self.camera.height
            deviations = [shift, shift, _SCALE, np.deg2rad(_ELEVATION_DEG)]
            free[: SHAPE - ANGLES] = 1 / np.square(deviations)
        if self.shape_is == "estimated":
            free[SHAPE - ANGLES :] = 1 / _SHAPE**2
        return free


def _outline_error(problem: Problem, parameters: Array) -> float:
    """Pixels by which the outline is off in the median frame."""
    errors = [
        outline_error(iou, problem.masks[f], problem.contours[f], problem.working.enlargement)
        for f, iou in zip(problem.frames, problem.overlaps(parameters), strict=True)
    ]
    return float(np.median(errors))


def _parameters_of(start: ArrayLike, others: ArrayLike | None, free: int) -> Array:
    """Parameters (F, 1 + S, 54 + free) of poses, the free ones 0."""
    poses = np.asarray(start, dtype=float)[:, None]
    if others is not None and np.shape(others)[1]:
        poses = np.concatenate([poses, np.asarray(others, dtype=float)], axis=1)
        without = ~np.isfinite(poses[:, 0, 0])
        poses[without, 0] = poses[without, 1]
    parameters = np.zeros((*poses.shape[:2], ANGLES + free))
    parameters[..., :ANGLES] = np.deg2rad(SPACE.angles(poses))
    return parameters
