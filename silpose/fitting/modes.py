"""Modes of a frame's posterior: where several starts lead, and which of them follow each other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from silpose.core.skeleton import EULER_ORDERS, JOINTS, other_side
from silpose.core.types import Array, Indices
from silpose.fitting.parameters import ANGLES
from silpose.fitting.prior import PosePrior

_ALIKE = np.deg2rad(1.0)  # mean difference of the angles of ends that are one mode
_STEP_SECONDS = 1 / 15  # in which legs that pass move farther than fits err
_LEG_JOINTS = [name for name in JOINTS if name.endswith(("hip", "knee", "ankle"))]

LEGS = [3 * JOINTS.index(name) + k for name in _LEG_JOINTS for k in range(3)]
"""Places of the angles of hips, knees and ankles."""
_OTHER_LEGS = [3 * JOINTS.index(other_side(name)) + k for name in _LEG_JOINTS for k in range(3)]
# A mirror at the plane of left and right turns about x as it was.
_SIGNS = np.array([1.0 if a == "X" else -1.0 for name in _LEG_JOINTS for a in EULER_ORDERS[name]])


class Modes(NamedTuple):
    """Modes of a frame's posterior, the most probable first.

    Attributes
    ----------
    parameters : ndarray, shape (k, P)
    hessians : ndarray, shape (k, P, P)
        Inverses of their covariances.
    costs : ndarray, shape (k,)
        Minus twice their log posterior densities, up to a constant.
    """

    parameters: Array
    hessians: Array
    costs: Array

    @classmethod
    def of(cls, ends: Sequence[tuple[Array, Array, float]]) -> Modes:
        """Collect where fits ended: parameters (P,), Hessians (P, P) and costs."""
        parameters, hessians, costs = (np.array(part) for part in zip(*ends, strict=True))
        kept = distinct(parameters, costs)
        return cls(parameters[kept], hessians[kept], costs[kept])


def legs_swapped(parameters: Array) -> Array:
    """Let each leg do what the other does, mirrored.

    From the side, both explain a silhouette about as well; which is which shows over time.

    Parameters
    ----------
    parameters : ndarray, shape (..., P)

    Returns
    -------
    parameters : ndarray, shape (..., P)
    """
    swapped = parameters.copy()
    swapped[..., LEGS] = _SIGNS * parameters[..., _OTHER_LEGS]
    return swapped


def distinct(parameters: Array, costs: Array) -> Indices:
    """Choose the cheapest of the ends that agree with each other, the cheapest of all first.

    Parameters
    ----------
    parameters : ndarray, shape (k, P)
    costs : ndarray, shape (k,)

    Returns
    -------
    kept : ndarray of int
    """
    kept: list[int] = []
    for end in np.argsort(costs, kind="stable"):
        apart = wrapped(parameters[kept, :ANGLES] - parameters[end, :ANGLES])
        if np.isfinite(costs[end]) and (np.abs(apart).mean(axis=1) > _ALIKE).all():
            kept.append(int(end))
    return np.array(kept or [0])


def weights_of(costs: Array) -> Array:
    """Probabilities of modes by minus twice their log posterior densities."""
    if not np.isfinite(costs).all():  # the body is out of sight
        return np.full(len(costs), 1 / len(costs))
    likely = np.exp(-(costs - np.min(costs)) / 2)
    return likely / likely.sum()


def spread_around(modes: Modes, chosen: int) -> Array:
    """Find what the other modes add to the covariance of the chosen one's angles, radians²."""
    off = wrapped(modes.parameters[:, :ANGLES] - modes.parameters[chosen, :ANGLES])
    spread: Array = np.einsum("k,ki,kj->ij", weights_of(modes.costs), off, off)
    return spread


def path_of_take(
    modes: Sequence[Array], costs: Sequence[Array], prior: PosePrior, step_seconds: float
) -> Indices:
    """Choose one of each frame's modes, at first of frames that are far enough apart.

    Whether legs pass or bounce off each other hardly shows in what a film's following frames
    differ by, which errors of the fits outweigh.

    Parameters
    ----------
    modes, costs
        As for `most_likely_path`.
    prior : PosePrior
    step_seconds : float
        From frame to frame.

    Returns
    -------
    path : ndarray of int, shape (F,)
    """
    apart = max(1, round(_STEP_SECONDS / step_seconds))
    anchors = _path(modes[::apart], costs[::apart], prior, apart * step_seconds)
    if apart == 1:
        return anchors
    open_to = [np.arange(len(own)) for own in costs]
    for frame, mode in zip(range(0, len(modes), apart), anchors, strict=True):
        open_to[frame] = np.array([mode])
    between = _path(
        [own[to] for own, to in zip(modes, open_to, strict=True)],
        [own[to] for own, to in zip(costs, open_to, strict=True)],
        prior,
        step_seconds,
    )
    return np.array([to[mode] for to, mode in zip(open_to, between, strict=True)])


def _path(
    modes: Sequence[Array], costs: Sequence[Array], prior: PosePrior, step_seconds: float
) -> Indices:
    change, bend = prior.change_within(step_seconds), prior.bend_within(step_seconds)
    return most_likely_path(modes, costs, change, bend)


def most_likely_path(
    modes: Sequence[Array], costs: Sequence[Array], change: Array, bend: Array
) -> Indices:
    """Choose one of each frame's modes by Viterbi's algorithm, of second order.

    That a pose changes little prefers legs that bounce off each other where they meet; that
    changes last prefers legs that pass.

    Parameters
    ----------
    modes : sequence of ndarray, each (k, P)
        Parameters, by frame.
    costs : sequence of ndarray, each (k,)
        Minus twice their log posterior densities.
    change, bend : ndarray, shape (54, 54)
        Covariances of the change of angles from a frame to the next, and of the change of that,
        radians².

    Returns
    -------
    path : ndarray of int, shape (F,)
    """
    whiten = np.linalg.inv(np.linalg.cholesky(change))
    whiten_bend = np.linalg.inv(np.linalg.cholesky(bend))
    total = np.asarray(costs[0])[None]  # by the mode before and the mode now
    steps = np.zeros((1, len(costs[0]), ANGLES))
    came_from: list[Indices] = []
    for t in range(1, len(modes)):
        new = wrapped(modes[t][None, :, :ANGLES] - modes[t - 1][:, None, :ANGLES])
        moved = ((new @ whiten.T) ** 2).sum(axis=2)
        through = total[:, :, None] + (moved + costs[t])[None]
        if t > 1:
            bends = (new @ whiten_bend.T)[None] - (steps @ whiten_bend.T)[:, :, None]
            through = through + (bends**2).sum(axis=3)
        came_from.append(through.argmin(axis=0))
        total, steps = through.min(axis=0), new
    before, now = np.unravel_index(int(np.argmin(total)), total.shape)
    path = [int(now)]
    for best in reversed(came_from):
        path.append(int(before))
        before, now = best[before, now], before
    return np.array(path[::-1])


def wrapped(angles: Array) -> Array:
    """Wrap differences of angles, radians, to half a turn."""
    return angles - 2 * np.pi * np.round(angles / (2 * np.pi))
