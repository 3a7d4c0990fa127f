"""Which leg is which, decided over a take."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from silpose.core.types import Array, Indices
from silpose.fitting.leg_motion import FIT_ERROR, LegMotion
from silpose.fitting.modes import LEGS, Modes, legs_swapped, wrapped
from silpose.fitting.parameters import ANGLES
from silpose.fitting.prior import PosePrior, news

ALIKE_SECONDS = 0.03
"""Time in which the errors of predicted legs decay."""

_UNTRIED = 30.0  # by how much more legs cost that were swapped, but not fitted again
_LONGEST = 1.5  # steps up to this many times the prediction's own tell how legs move on
_SWAPPED = legs_swapped(np.eye(ANGLES)).T


def told_apart(
    modes: Sequence[Modes],
    path: Indices,
    motion: LegMotion,
    prior: PosePrior,
    share: float,
    step_seconds: float,
) -> tuple[list[Modes], Indices]:
    """Decide for each frame of a path whether its mode, or the one with swapped legs, is right.

    Parameters
    ----------
    modes : sequence of Modes
        Of each frame.
    path : ndarray of int, shape (F,)
        The mode of each frame.
    motion : LegMotion
    prior : PosePrior
    share : float
        Of a frame's cost that is not in the frames before it.
    step_seconds : float
        From frame to frame.

    Returns
    -------
    modes : list of Modes
        With those whose legs had not been swapped yet.
    path : ndarray of int, shape (F,)
    """
    found = [_with_swapped(own, int(k)) for own, k in zip(modes, path, strict=True)]
    pairs = [np.array([k, swapped]) for k, (_, swapped) in zip(path, found, strict=True)]
    whole = [own for own, _ in found]
    legs = np.stack([m.parameters[pair][:, LEGS] for m, pair in zip(whole, pairs, strict=True)])
    costs = share * np.stack([m.costs[pair] for m, pair in zip(whole, pairs, strict=True)])
    change = prior.change_within(step_seconds)[np.ix_(LEGS, LEGS)]
    which = legs_along(legs, costs, motion, change, step_seconds)
    return whole, np.stack(pairs)[np.arange(len(pairs)), which]


def _with_swapped(modes: Modes, chosen: int) -> tuple[Modes, int]:
    """Find the mode that is the chosen one with its legs swapped, or add it."""
    own = modes.parameters[chosen]
    aim = legs_swapped(own)
    off = np.abs(modes.parameters[:, LEGS] - aim[LEGS]).mean(axis=1)
    nearest = int(np.argmin(off))
    if nearest != chosen and off[nearest] < off[chosen] / 2:
        return modes, nearest
    turned = np.eye(len(own))
    turned[:ANGLES, :ANGLES] = _SWAPPED
    added = Modes(
        np.concatenate([modes.parameters, aim[None]]),
        np.concatenate([modes.hessians, (turned @ modes.hessians[chosen] @ turned.T)[None]]),
        np.append(modes.costs, modes.costs[chosen] + _UNTRIED),
    )
    return added, len(modes.costs)


def legs_along(
    legs: Array, costs: Array, motion: LegMotion, change: Array, step_seconds: float
) -> Indices:
    """Choose one of two explanations of each frame, whose legs are swapped.

    It may change only where the legs are nearest to each other, but from there on the choice is the
    best of all, by how legs move from frame to frame and how they move on over a longer time.

    Parameters
    ----------
    legs : ndarray, shape (F, 2, 18)
        Angles of hips, knees and ankles, radians.
    costs : ndarray, shape (F, 2)
        Minus twice their log posterior densities, as far as frames are independent.
    motion : LegMotion
    change : ndarray, shape (18, 18)
        Covariance of the change from a frame to the next, radians².
    step_seconds : float
        From frame to frame.

    Returns
    -------
    chosen : ndarray of int, shape (F,)
    """
    apart = max(1, round(motion.seconds / step_seconds))
    if step_seconds > _LONGEST * motion.seconds or len(legs) <= 2 * apart:
        return np.zeros(len(legs), np.intp)
    precision = np.linalg.inv(change + 2 * FIT_ERROR * np.eye(len(LEGS))).astype(np.float64)
    moved = _moved(legs, precision)
    # At first, each leg is where the same one was a frame ago; then swaps are where legs meet.
    first = np.append(0, (_cost_of_swapping(moved) < 0).cumsum() % 2)
    ordered = np.stack([first, 1 - first], axis=1)
    legs, costs = (
        np.take_along_axis(own, order, axis=1)
        for own, order in ((legs, ordered[:, :, None]), (costs, ordered))
    )
    moved = _moved(legs, precision)
    on = motion.predicted(legs[: -2 * apart, :, None], legs[apart:-apart, None])
    off: Array = legs[2 * apart :, None, None] - on[:, :, :, None]
    went_on = news(step_seconds, ALIKE_SECONDS) * _squares(off, motion.precision)

    part = _parts(_cost_of_swapping(moved), apart)
    best = _best_choices(_Costs(costs, moved, went_on), part)[part]
    return ordered[np.arange(len(best)), best]


def _moved(legs: Array, precision: Array) -> Array:
    """Cost of each step (F-1, 2, 2), by the choice before and the choice now."""
    steps: Array = legs[1:, None, :] - legs[:-1, :, None]
    return _squares(steps, precision)


def _cost_of_swapping(moved: Array) -> Array:
    """How much more the step to each next frame costs if legs are swapped on the way, (F-1,)."""
    cost: Array = moved[:, 0, 1] + moved[:, 1, 0] - moved[:, 0, 0] - moved[:, 1, 1]
    return cost


class _Costs(NamedTuple):
    """Of the choices in a frame (F, 2), of those in two (F-1, 2, 2), and in three (., 2, 2, 2)."""

    own: Array
    moved: Array
    went_on: Array

    def of_part(self, part: Indices, now: int) -> Array:
        """Cost of the frames of one part by the choices in the two before it and in itself."""
        apart = (len(self.own) - len(self.went_on)) // 2
        t = np.arange(*np.searchsorted(part, [now, now + 1]))
        after, later = t[t > 0], t[t >= 2 * apart]
        total = np.empty((2, 2, 2))
        for choice in np.ndindex(total.shape):
            of_last = np.array(choice)
            last, before, earlier = (
                of_last[2 + part[frames] - now]
                for frames in (after - 1, later - apart, later - 2 * apart)
            )
            total[choice] = (
                self.own[t, choice[2]].sum()
                + self.moved[after - 1, last, choice[2]].sum()
                + self.went_on[later - 2 * apart, earlier, before, choice[2]].sum()
            )
        return total


def _best_choices(costs: _Costs, part: Indices) -> Indices:
    """Choose for every part, by dynamic programming over the choices in the last three."""
    total = np.zeros((2, 2, 2))
    came_from: list[Indices] = []
    for now in range(part[-1] + 1):
        through = total[..., None] + costs.of_part(part, now)
        came_from.append(through.argmin(axis=0))
        total = through.min(axis=0)
    first, second, last = (int(k) for k in np.unravel_index(int(total.argmin()), total.shape))
    choices = [last]
    for best in reversed(came_from[1:]):
        first, second, last = int(best[first, second, last]), first, second
        choices.append(last)
    return np.array(choices[::-1])


def _parts(swap_costs: Array, apart: int) -> Indices:
    """Cut a take where legs may be swapped, and number its parts: the part of each frame, (F,)."""
    begins = np.zeros(len(swap_costs) + 1, np.intp)
    free = np.ones(len(swap_costs), np.bool_)
    for t in np.argsort(swap_costs, kind="stable"):
        if free[t]:
            begins[t + 1] = 1
            free[max(0, t - apart + 1) : t + apart] = False
    return begins.cumsum()


def _squares(off: Array, precision: Array) -> Array:
    off = wrapped(off)
    squares: Array = (off @ precision * off).sum(axis=-1)
    return squares
