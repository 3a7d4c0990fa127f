"""Fitting live: each frame from its estimate, and from the last fit moved on.

The pose at frame t has two priors: the estimate e, whose errors have the covariance S, and the
pose that is expected from the fits before, m, with the covariance T of what may have happened
since. Both are Gaussians with outliers: an estimate may be of the person seen from behind, and
the person may have been followed wrongly. Where the two disagree, each leads to a fit, and the
one that explains the mask better counts; if both explain it, what is expected, until estimates
have disagreed for a while.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES as SPACE
from silpose.core.types import Array, Mask
from silpose.fitting.body_fitter import BodyFitter
from silpose.fitting.confidence import DOUBTFUL
from silpose.fitting.evidence import EVIDENCE, Fitted, evidence_of
from silpose.fitting.expected_pose import ExpectedPose
from silpose.fitting.frame_fit import Gaussian, cost_of_turning, fit_frame
from silpose.fitting.geometry import geometry_of
from silpose.fitting.image_scale import ImageScale
from silpose.fitting.likelihood import Observation
from silpose.fitting.live_frame import End, Seen
from silpose.fitting.parameters import ANGLES, difference
from silpose.fitting.prior import CONTOUR_SECONDS, news
from silpose.fitting.working_size import WorkingSize, expected_height

TOLERATED = 0.75
"""Share of the usual overlap of body and mask below which the person counts as lost."""

_NEW_START = 60.0  # cost of a pose that does not follow from those before,
_WRONG_ESTIMATE = 10.0  # and, for each frame running, of one far from the estimate
# Squared distance of an estimate from what is expected, in standard deviations of 54 angles,
_USUAL = 30.0  # up to which that alone is tried if it explains the mask, and
_PLAUSIBLE = 100.0  # up to which both may be right
_WORSE = 1.5  # factor of what body and mask usually do not share, from which both are tried
_ITERATIONS, _AT_FIRST = {"known": 4, "estimated": 8}, 8
_TURNED = 3  # iterations of a fit turned around, for comparison


class FitterStream:
    """Fits the body to one mask after another; the fitter is not changed.

    Parameters
    ----------
    fitter : BodyFitter
        With an estimated camera, the image's shift and scale are fitted; the elevation and the
        body's shape are the fitter's. With an estimated shape, clothes are allowed for.
    usual_iou : float, optional
        Overlap of body and mask in training, by which a fit is judged; by default that of the
        fitter's confidence.
    frames_per_second : float, default=15.0
    iterations : int, optional
        Gauss-Newton steps of each start, by default 4, or 8 where the camera is estimated; at
        least 8 while no person is followed.

    Attributes
    ----------
    iou : float
        Overlap of the body and the last mask; NaN before the first one and if it was blank.
    covariance : ndarray, shape (54, 54)
        Of the last fit's angles, degrees²; NaN where there is none.
    confidence : float
        Probability that the last pose is right, as `Fit.confidence`; 0 where nothing was fitted.
    evidence : ndarray, shape (9,)
        What it is read from, see `EVIDENCE`; NaN where nothing was fitted.
    shift, scale : ndarray, shape (2,), and float
        Of the image, as of `Fit`; NaN where nothing was fitted.
    """

    def __init__(
        self,
        fitter: BodyFitter,
        *,
        usual_iou: float | None = None,
        frames_per_second: float = 15.0,
        iterations: int | None = None,
    ) -> None:
        self._fitter, self._geometry = fitter, geometry_of(fitter.body)
        self._resize(WorkingSize.for_person(fitter.camera, expected_height(fitter.camera)))
        self._usual_iou = usual_iou or fitter.confidence.usual_iou
        self._sure = replace(fitter.confidence, usual_iou=self._usual_iou)
        self._change = fitter.prior.change_within(1 / frames_per_second)
        self._contour_news = news(1 / frames_per_second, CONTOUR_SECONDS)
        self._estimate_news = news(1 / frames_per_second, fitter.prior.seconds)
        clothed = fitter.shape_is == "estimated"
        self._matching = fitter.matching.clothed() if clothed else fitter.matching
        self._precision = fitter.prior.precision
        self._errors = np.linalg.inv(self._precision).astype(float)
        self._without_heading = np.linalg.inv(self._errors[1:, 1:]).astype(float)
        self._iterations = iterations or _ITERATIONS[fitter.camera_is]
        self._expected: ExpectedPose | None = None
        self._scale = ImageScale(self._geometry)
        self._state = "starting"
        self._overruled = 0  # frames running in which what was expected counted, not the estimate
        self._forget()

    def skip(self, frames: int) -> None:
        """Let frames go by of which nothing is known, not even that they were blank."""
        self._expected = self._expected and self._expected.later(frames)

    def step(
        self, mask: Mask, start: ArrayLike | None = None, root: ArrayLike | None = None
    ) -> tuple[Array, str]:
        """Fit the next frame.

        Parameters
        ----------
        mask : ndarray, shape (H, W)
            Blank or not, of the camera's size.
        start : array-like, shape (55,), optional
            Estimated pose, of a regressor or a tracker; NaN where there is none.
        root : array-like, shape (3,), optional
            Root relative to what the camera looks at, metres; at the origin by default.

        Returns
        -------
        x : ndarray, shape (55,)
            The pose; where nothing can be fitted the last one, or NaN if there is none.
        state : str
            ``starting`` until the body explains a mask, then ``tracking``; ``lost`` where the
            confidence is below a half, as the body explains the mask much worse than is usual or
            only by a pose that is far from all that was estimated, or where the mask is blank;
            ``recovered`` in the first frame after that.

        Raises
        ------
        InputError
            If the mask is of another size than the camera's.
        """
        camera = self._fitter.camera
        if np.shape(mask) != (camera.height, camera.width):
            raise InputError(
                f"a mask has shape {np.shape(mask)} where the camera's is "
                f"{(camera.height, camera.width)}: give masks of one size, that of the camera"
            )
        if self._fitter.camera_is == "estimated":
            self._resize(self._working.followed(camera, mask))
        seen = Seen.of(mask, start, root, self._working)
        end = self._fit(seen) if len(seen.contour.pixels) else None
        if end is None:
            self._forget()
            self._miss()
            held = np.full(ANGLES, np.nan) if self._expected is None else self._expected.fitted
            return SPACE.from_angles(np.rad2deg(held)), self._state
        before = None if self._expected is None else self._expected.precision
        covariance = end.covariance(before, self._contour_news, self._estimate_news)
        self.iou, self.covariance = end.iou, np.rad2deg(np.rad2deg(covariance))
        self.evidence = self._evidence(end, covariance, seen)
        self.confidence = float(self._sure.of(self.evidence[None])[0])
        self.shift, self.scale = end.placed(self._working.factor)
        if self.confidence >= DOUBTFUL:
            self._follow(end, covariance)
        else:
            self._miss()
        return SPACE.from_angles(np.rad2deg(end.parameters[:ANGLES])), self._state

    def _fit(self, seen: Seen) -> End | None:
        """Fit from what is expected and, if that may be wrong, from the estimate alone."""
        expected, estimate = self._expected, seen.estimate
        if expected is None:
            return None if estimate is None else self._end(estimate, self._precision, seen)
        if estimate is None:
            return self._end(expected.mean, expected.precision, seen, expected.mean)
        off = difference(estimate, expected.mean)
        apart = off @ np.linalg.solve(expected.covariance + self._errors, off)
        prior = expected.mean, expected.precision
        if apart < _PLAUSIBLE:
            prior = expected.together_with(estimate, self._precision)
        ends = [self._end(*prior, seen, expected.mean)]
        if apart > _USUAL or 1 - ends[0].iou > _WORSE * (1 - self._usual_iou):
            ends.append(self._end(estimate, self._precision, seen))
        best = int(np.argmin([self._cost(end, seen) for end in ends]))
        self._overruled = self._overruled + 1 if best < len(ends) - 1 else 0
        return ends[best]

    def _end(self, mean: Array, precision: Array, seen: Seen, start: Array | None = None) -> End:
        """Fit from a start, or from the prior's mean as a start of its own."""
        angles = mean if start is None else start
        if self._fitter.camera_is == "estimated":
            mean = self._scale.placed(mean, seen.root, seen.contour, self._view)
            precision = self._scale.precision_with(
                precision, self._working.factor * self._fitter.camera.height
            )
            angles = np.concatenate([angles, mean[ANGLES:]])
        follows = self._state in ("tracking", "recovered")
        iterations = self._iterations if follows else max(self._iterations, _AT_FIRST)
        prior, observation = Gaussian(mean, precision), self._observation(seen)
        parameters, hessian, _, misfit = fit_frame(angles, prior, observation, iterations, 0)
        of = seen.root, self._geometry, self._fitter.view
        iou = self._working.overlap(seen.mask, parameters, *of)
        return End(parameters, hessian, precision, misfit, iou, start is None)

    def _cost(self, end: End, seen: Seen) -> float:
        """Minus twice the log posterior, in which what is far away costs no more than a limit."""
        parameters, expected = end.parameters, self._expected
        cost = end.misfit
        if seen.estimate is not None:
            off = difference(parameters[:ANGLES], seen.estimate)
            wrong = _WRONG_ESTIMATE * (1 + self._overruled)
            cost += min(wrong, float(off @ self._precision @ off))
        if expected is not None:
            off = difference(parameters[:ANGLES], expected.mean)
            cost += min(_NEW_START, float(off @ expected.precision @ off))
        return cost

    def _evidence(self, end: End, covariance: Array, seen: Seen) -> Array:
        """Compare a fit with its estimate, or with what is expected where there is none."""
        other = seen.estimate
        if other is None:
            other = end.parameters[:ANGLES] if self._expected is None else self._expected.mean
        observation = self._observation(seen)
        prior = Gaussian(np.concatenate([other, end.parameters[ANGLES:]]), end.precision)
        turning = cost_of_turning(end.parameters, end.misfit, prior, observation, _TURNED)
        fitted = Fitted(end.parameters, covariance, end.iou, turning)
        return evidence_of(fitted, other, self._without_heading, observation)

    def _observation(self, seen: Seen) -> Observation:
        return Observation(seen.contour, seen.root, self._geometry, self._view, self._matching)

    def _resize(self, working: WorkingSize) -> None:
        self._working, self._view = working, working.view(self._fitter.view)

    def _forget(self) -> None:
        self.iou, self.covariance = np.nan, np.full((ANGLES, ANGLES), np.nan)
        self.confidence, self.evidence = 0.0, np.full(len(EVIDENCE), np.nan)
        self.shift, self.scale = np.full(2, np.nan), np.nan

    def _follow(self, end: End, covariance: Array) -> None:
        parameters = end.parameters
        self._expected = ExpectedPose.after(
            None if end.anew else self._expected, parameters[:ANGLES], covariance, self._change
        )
        if len(parameters) > ANGLES:
            self._scale.add(parameters)
        self._state = "recovered" if self._state == "lost" else "tracking"

    def _miss(self) -> None:
        self.skip(1)
        if self._state != "starting":
            self._state = "lost"
