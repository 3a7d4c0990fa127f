"""Left and right of a skeleton: by names that say a side, else by where knees and toes point."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from silpose.core.types import Array
from silpose.motion.capture.naming.tree import JointTree

CERTAIN = 0.85
"""Smallest share of frames that must agree."""

ASIDE = 0.25
"""Smallest cosine between two hips or shoulders and the line across the way a person faces."""

BENT = 0.04
"""Smallest distance of a bent knee from the line from hip to ankle, relative to the leg."""

FOOT = 0.08
"""Shortest foot by which to tell where a person faces, relative to the leg."""

Joints = tuple[int, int, int]


class Unclear(Exception):
    """The shape does not tell which joint is which; the text says why."""


def left_one(
    tree: JointTree,
    feet: Sequence[tuple[Joints, int | None]],
    arms: Sequence[Joints],
    chest: int,
    known: Mapping[str, int],
) -> tuple[int, int]:
    """Tell which leg and which arm is the left one.

    Parameters
    ----------
    tree : JointTree
    feet : sequence of ((int, int, int), int or None)
        Hip, knee and ankle of either leg, and the ball of its foot.
    arms : sequence of (int, int, int)
        Shoulder, elbow and wrist of either arm.
    chest : int
        Node where the arms branch off.
    known : mapping of str to int
        Joints that are known, and thereby their sides.

    Returns
    -------
    leg, arm : int
        0 or 1.

    Raises
    ------
    Unclear
    """
    legs = [joints for joints, _ in feet]
    leg, arm = (_by_names(tree, limbs, known) for limbs in (legs, arms))
    if leg is not None and arm is not None:
        return leg, arm
    p = tree.positions
    if leg is not None or arm is not None:  # the other one follows from the hip or shoulder line
        limbs, k = (legs, leg) if leg is not None else (arms, arm)
        assert k is not None
        line = p[:, limbs[k][0]] - p[:, limbs[1 - k][0]]
    else:
        up = _unit(p[:, chest] - (p[:, legs[0][2]] + p[:, legs[1][2]]) / 2)
        line = np.cross(up, _forward(tree, feet, up))
    return (
        _on_side(p, legs, line, "hips") if leg is None else leg,
        _on_side(p, arms, line, "shoulders") if arm is None else arm,
    )


def _by_names(tree: JointTree, limbs: Sequence[Joints], known: Mapping[str, int]) -> int | None:
    """Which of two limbs has names of the left side, or the other one of the right, if any."""
    sides = {node: ours.partition("_")[0] for ours, node in known.items()}
    votes = [0, 0]
    for k, joints in enumerate(limbs):
        for j in joints:
            votes[k] += {"left": 1, "right": -1}.get(sides.get(j) or tree.words[j].side, 0)
    if votes[0] == votes[1]:
        return None
    return 0 if votes[0] > votes[1] else 1


def _forward(tree: JointTree, feet: Sequence[tuple[Joints, int | None]], up: Array) -> Array:
    """Where the person faces, (F, 3): by toes, and by knees where they are bent."""
    p = tree.positions
    toes, knees = np.zeros_like(up), np.zeros_like(up)
    for (hip, knee, ankle), ball in feet:
        leg = _unit(p[:, ankle] - p[:, hip])
        size = np.linalg.norm(p[:, ankle] - p[:, hip], axis=-1).max()
        if ball is not None:
            foot = _across(p[:, ball] - p[:, ankle], up)
            toes += foot if np.median(np.linalg.norm(foot, axis=-1)) > FOOT * size else 0.0
        aside = _across(p[:, knee] - p[:, hip], leg)
        bent = np.linalg.norm(aside, axis=-1, keepdims=True) > BENT * size
        knees += np.where(bent, _across(aside, up), 0.0)
    by_toes, by_knees = (bool(np.abs(v).max() > 0) for v in (toes, knees))
    if by_toes and by_knees:
        moved = np.linalg.norm(knees, axis=-1) > 0
        agree = (np.sum(toes * knees, axis=-1) > 0)[moved]
        if agree.mean() < CERTAIN:
            raise Unclear("its knees do not bend to where its toes point")
    if not by_toes and not by_knees:
        raise Unclear("neither feet nor bent knees tell where it faces")
    if by_toes:
        return toes
    return np.where(np.linalg.norm(knees, axis=-1, keepdims=True) > 0, knees, np.nan)


def _on_side(p: Array, limbs: Sequence[Joints], line: Array, what: str) -> int:
    """Which of two limbs begins further along a line, in nearly all frames."""
    apart = p[:, limbs[0][0]] - p[:, limbs[1][0]]
    known = np.isfinite(line).all(axis=-1)
    along = np.sum(_unit(apart[known]) * _unit(line[known]), axis=-1)
    for k, sign in enumerate((1, -1)):
        if len(along) and np.mean(sign * along > ASIDE) >= CERTAIN:
            return k
    raise Unclear(f"its {what} are not clearly on one side of where it faces")


def _across(v: Array, axis: Array) -> Array:
    return v - axis * np.sum(v * axis, axis=-1, keepdims=True)


def _unit(v: Array) -> Array:
    return v / np.maximum(np.linalg.norm(v, axis=-1, keepdims=True), 1e-12)
