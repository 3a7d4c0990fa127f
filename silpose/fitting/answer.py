"""From fitted parameters to the answer: every frame of a take with its state."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from silpose.core.pose_space import ANGLES as SPACE
from silpose.core.types import Array
from silpose.fitting.confidence import Confidence
from silpose.fitting.evidence import EVIDENCE, Fitted, evidence_of
from silpose.fitting.fit import Fit, state_of
from silpose.fitting.modes import Modes, weights_of
from silpose.fitting.parameters import (
    ANGLES,
    ELEVATION,
    LOG_SCALE,
    PARAMETERS,
    SHAPE,
    SHIFT_X,
    SHIFT_Y,
)
from silpose.fitting.problem import Problem


def answer_of(
    problem: Problem,
    parameters: Array,
    covariance: Array,
    modes: Sequence[Modes],
    confidence: Confidence,
) -> Fit:
    """Put the fitted frames where they belong, with what speaks for and against them.

    Parameters
    ----------
    problem : Problem
    parameters : ndarray, shape (n, P)
        Of the problem's frames.
    covariance : ndarray, shape (n, 54, 54)
        Of their angles, radians².
    modes : sequence of Modes
        Theirs.
    confidence : Confidence

    Returns
    -------
    fit : Fit
    """
    frames, every = problem.frames, _complete(parameters)
    count, most = len(problem.starts), max(len(m.costs) for m in modes)
    x, shift = np.full((count, ANGLES + 1), np.nan), np.full((count, 2), np.nan)
    scale, iou = np.full(count, np.nan), np.full(count, np.nan)
    spread = np.full((count, ANGLES, ANGLES), np.nan)
    evidence = np.full((count, len(EVIDENCE)), np.nan)
    poses, weights = np.full((count, most, ANGLES + 1), np.nan), np.zeros((count, most))
    x[frames], scale[frames] = _poses(every), np.exp(every[:, LOG_SCALE])
    shift[frames] = every[:, [SHIFT_X, SHIFT_Y]] / problem.working.factor
    spread[frames] = np.rad2deg(np.rad2deg(covariance))
    iou[frames] = problem.overlaps(parameters)
    turning = problem.costs_of_turning(parameters)
    errors = np.linalg.inv(np.deg2rad(np.deg2rad(problem.prior.covariance[1:, 1:])))
    for k, frame in enumerate(frames):
        poses[frame, : len(modes[k].costs)] = _poses(modes[k].parameters)
        weights[frame, : len(modes[k].costs)] = weights_of(modes[k].costs)
        fitted = Fitted(parameters[k], covariance[k], iou[frame], turning[k])
        estimate = problem.starts[frame, 0, :ANGLES]
        evidence[frame] = evidence_of(fitted, estimate, errors, problem.observation(frame))
    sure = confidence.of(evidence)
    shared = np.median(every, axis=0)
    return Fit(
        x, spread, iou, sure, [state_of(*of) for of in zip(iou, sure, strict=True)], shift, scale,
        float(np.rad2deg(problem.view.elevation + shared[ELEVATION])), shared[SHAPE:],
        poses, weights, evidence,
    )  # fmt: skip


def _complete(parameters: Array) -> Array:
    """All 68 parameters, 0 where they are known."""
    every = np.zeros((len(parameters), PARAMETERS))
    every[:, : parameters.shape[1]] = parameters
    return every


def _poses(parameters: Array) -> Array:
    return SPACE.from_angles(np.rad2deg(parameters[:, :ANGLES]))
