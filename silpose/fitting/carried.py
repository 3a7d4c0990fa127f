"""Further modes of a take's frames: each frame fitted from where the one before, or after, ended.

A frame's own starts may all lead to a wrong explanation, with the legs swapped for example. What
its neighbours found is then near the right one.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial

import numpy as np

from silpose.core.parallel import parallel_map
from silpose.core.types import Array
from silpose.fitting.modes import Modes
from silpose.fitting.parameters import ANGLES, difference
from silpose.fitting.problem import End, Problem

_LOST = 60.0  # by how much more than a frame's best mode a carried end may cost


def with_carried(problem: Problem, modes: Sequence[Modes]) -> list[Modes]:
    """Add the ends of fits that are carried through a take, forwards and backwards.

    Parameters
    ----------
    problem : Problem
    modes : sequence of Modes
        Of its frames.

    Returns
    -------
    modes : list of Modes
        With those ends that are modes of their own.
    """
    order = range(len(modes))
    passes = parallel_map(partial(_carried, problem, modes), [order, order[::-1]], prefer="threads")
    return [_joined(own, [ends[k] for ends in passes if k in ends]) for k, own in enumerate(modes)]


def _carried(problem: Problem, modes: Sequence[Modes], order: Iterable[int]) -> dict[int, End]:
    """Fit each frame from the last one moved on; a pass that is lost starts anew."""
    ends: dict[int, End] = {}
    last: Array | None = None
    step = np.zeros(ANGLES)
    for k in order:
        if last is not None:
            start = last.copy()
            start[:ANGLES] += step
            cheapest = modes[k].costs[0]
            for end in problem.ends(problem.frames[k], start[None], cheapest):
                ends[k] = end
            if k in ends and ends[k][2] < cheapest + _LOST:
                parameters = ends[k][0]
                step, last = difference(parameters, last)[:ANGLES], parameters
                continue
        step, last = np.zeros(ANGLES), modes[k].parameters[0]
    return ends


def _joined(own: Modes, ends: Sequence[End]) -> Modes:
    return Modes.of([*zip(*own, strict=True), *ends]) if ends else own
