"""A whole take at once: poses that follow each other, and what all frames share.

With u_t the error of the estimate at frame t, b its lasting part and φ = exp(-Δt / τ),

    u_0 - b ~ N(0, (1 - ρ) S),   u_t - b ~ N(φ (u_{t-1} - b), (1 - φ²) (1 - ρ) S),   b ~ N(0, ρ S),

so that the normal equations of all frames are block-tridiagonal in u, with a border: b, the
camera's elevation and the body's shape.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from silpose.core.parallel import parallel_map
from silpose.core.types import Array
from silpose.fitting.likelihood import Observation, add_evidence
from silpose.fitting.limits import add_limits
from silpose.fitting.parameters import ANGLES, CONVERGED, ELEVATION, difference, take_step
from silpose.fitting.prior import CONTOUR_SECONDS, PosePrior, news


def fit_take(
    parameters: Array,
    mean: Array,
    free_precision: Array,
    prior: PosePrior,
    step_seconds: float,
    observations: Sequence[Observation],
    iterations: int,
) -> tuple[Array, Array]:
    """Minimise misfit and distance from the prior over all frames.

    Parameters
    ----------
    parameters : ndarray, shape (F, P)
        To start from, the shared ones alike in all frames.
    mean : ndarray, shape (F, P)
        Estimates; those of shift, scale, elevation and shape are what is expected of them.
    free_precision : ndarray, shape (P - 54,)
        Of the prior on image shift, scale, elevation and shape.
    prior : PosePrior
    step_seconds : float
        From frame to frame.
    observations : sequence of Observation
        Their contours without points where there is nothing to see.
    iterations : int

    Returns
    -------
    parameters : ndarray, shape (F, P)
    covariances : ndarray, shape (F, 54, 54)
        Of the angles, radians². Contours of following frames err alike, which moves the poses
        little, but makes them less certain than their number says.
    """
    frames, parameters = len(parameters), parameters.copy()
    chain = _Chain(prior, step_seconds, frames, free_precision)
    for _ in range(iterations):
        seen = list(zip(parameters, observations, strict=True))
        parts = parallel_map(_evidence, seen, prefer="threads")
        hessians = np.stack([hessian for hessian, _ in parts])
        gradients = np.stack([gradient for _, gradient in parts])
        errors = np.stack([difference(p, m) for p, m in zip(parameters, mean, strict=True)])
        new, _ = chain.solve(hessians, gradients, errors, certainty=False)
        shares = [take_step(p, step) for p, step in zip(parameters, new - errors, strict=True)]
        if max(shares) < CONVERGED:
            break
    share = news(step_seconds, CONTOUR_SECONDS)
    return parameters, chain.solve(share * hessians, share * gradients, errors)[1]


def _evidence(frame: tuple[Array, Observation]) -> tuple[Array, Array]:
    """Add up the normal equations of one frame, 0 where there is nothing to see."""
    parameters, observation = frame
    size = len(parameters)
    hessian, gradient = np.zeros((size, size)), np.zeros(size)
    if len(observation.contour.pixels):
        add_evidence(parameters, observation, hessian, gradient)
        add_limits(parameters, hessian, gradient)
    return hessian, gradient


class _Chain:
    """Prior of a take, and the solution of its bordered block-tridiagonal normal equations.

    The border holds the lasting error b (54) and the shared parameters (11).
    """

    def __init__(
        self, prior: PosePrior, step_seconds: float, frames: int, free_precision: Array
    ) -> None:
        self.width = min(ANGLES + len(free_precision), ELEVATION)  # parameters of a frame's own
        shared = ANGLES + len(free_precision) - self.width
        phi = np.exp(-step_seconds / prior.seconds)
        own, border = np.zeros((self.width, self.width)), np.zeros((self.width, ANGLES + shared))
        first = own.copy()
        first[:ANGLES, :ANGLES] = prior.precision / (1 - prior.lasting)
        later = first / (1 - phi**2)
        self.off = -phi * later
        self.own = np.stack([own] * frames)
        self.border = np.stack([border] * frames)
        block = later[:ANGLES, :ANGLES]
        for t in range(frames):
            self.own[t] += first if t == 0 else later
            self.border[t, :ANGLES, :ANGLES] -= (
                first[:ANGLES, :ANGLES] if t == 0 else (1 - phi) * block
            )
            if t < frames - 1:
                self.own[t] += phi**2 * later
                self.border[t, :ANGLES, :ANGLES] += phi * (1 - phi) * block
            moved = range(ANGLES, self.width)
            self.own[t][moved, moved] += free_precision[: self.width - ANGLES]
        self.corner = np.zeros((ANGLES + shared, ANGLES + shared))
        self.corner[:ANGLES, :ANGLES] = (
            first[:ANGLES, :ANGLES]
            + (frames - 1) * (1 - phi) ** 2 * block
            + prior.precision / max(prior.lasting, 1e-6)
        )
        alike = range(ANGLES, ANGLES + shared)
        self.corner[alike, alike] += free_precision[self.width - ANGLES :]

    def solve(
        self, hessians: Array, gradients: Array, errors: Array, *, certainty: bool = True
    ) -> tuple[Array, Array]:
        """Minimise the quadratic model, in terms of parameters less their expected values.

        Parameters
        ----------
        hessians, gradients : ndarray, shapes (F, P, P) and (F, P)
            Of the likelihood, at the present parameters.
        errors : ndarray, shape (F, P)
            Present parameters less their expected values.
        certainty : bool, default=True
            Whether covariances are wanted, which take as long again.

        Returns
        -------
        errors : ndarray, shape (F, P)
        covariances : ndarray, shape (F, 54, 54)
            0 where they are not wanted.
        """
        frames, width = len(errors), self.width
        right = gradients + np.einsum("tij,tj->ti", hessians, errors)
        diagonal = self.own + hessians[:, :width, :width]
        border = self.border.copy()
        border[:, :, ANGLES:] += hessians[:, :width, width:]
        corner = self.corner.copy()
        corner[ANGLES:, ANGLES:] += hessians[:, width:, width:].sum(axis=0)
        sides = np.concatenate([right[:, :width, None], border], axis=2)
        forward, solved, gains = diagonal, sides, np.empty((frames - 1, width, width))
        for t in range(1, frames):
            before = np.linalg.solve(forward[t - 1], np.hstack([self.off.T, solved[t - 1]]))
            gains[t - 1], solved[t - 1] = before[:, :width], before[:, width:]
            forward[t] -= self.off @ gains[t - 1]
            solved[t] -= self.off @ solved[t - 1]
        solved[-1] = np.linalg.solve(forward[-1], solved[-1])
        for t in range(frames - 2, -1, -1):
            solved[t] -= gains[t] @ solved[t + 1]
        covariances = np.zeros((frames, ANGLES, ANGLES))
        if certainty:
            inverse = np.linalg.inv(forward[-1])
            covariances[-1] = inverse[:ANGLES, :ANGLES]
            for t in range(frames - 2, -1, -1):
                inverse = np.linalg.inv(forward[t]) + gains[t] @ inverse @ gains[t].T
                covariances[t] = inverse[:ANGLES, :ANGLES]
        own, through = solved[:, :, 0], solved[:, :, 1:]
        reduced = corner - np.einsum("tib,tic->bc", border, through)
        target = np.concatenate([np.zeros(ANGLES), right[:, width:].sum(axis=0)])
        target -= np.einsum("tib,ti->b", border, own)
        shared = np.linalg.solve(reduced, target)
        if certainty:
            told = through[:, :ANGLES]
            covariances += told @ np.linalg.inv(reduced) @ np.swapaxes(told, 1, 2)
        new = np.empty_like(errors)
        new[:, :width] = own - through @ shared
        new[:, width:] = shared[ANGLES:]
        return new, covariances
