"""Joints without known names, by the shape of the skeleton: two arms, two legs, what holds them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations, pairwise

import numpy as np

from silpose.core.types import Array
from silpose.motion.capture.naming.limbs_by_name import ARM, LEG, OPTIONAL
from silpose.motion.capture.naming.sides import Unclear, left_one
from silpose.motion.capture.naming.tree import JointTree

ALIKE = 0.15
"""Largest difference of the lengths of a left and a right bone, relative to the longer one."""

SHORTEST_LIMB = 0.4
"""Shortest limb, relative to the longest."""

LIMB_RATIO = 0.6
"""Smallest ratio of the lengths of a limb's two bones."""

LEG_TO_ARM = 1.15
"""Smallest ratio of the length of the legs to that of the arms."""

STRAIGHT = 4.0
"""Largest angle between two parts of one bone, degrees."""

BENDS = 8.0
"""Smallest range of a joint's angle by which it is known to bend, degrees."""

_TINY = 0.02  # of the longest limb: shorter bones are offsets, not bones


@dataclass(frozen=True)
class _Limb:
    """Three joints of two bones, and the joint before and the node after them on their chain."""

    joints: tuple[int, int, int]
    before: int | None
    after: int | None
    length: float
    first: int  # node of the chain
    place: tuple[int, ...]  # of the joints in the chain


@dataclass(frozen=True)
class _Pair:
    """Two limbs of one shape at the same node."""

    top: int
    limbs: tuple[_Limb, _Limb]


def limbs_by_shape(tree: JointTree, known: Mapping[str, int]) -> dict[str, int]:
    """Find collars, shoulders, elbows, wrists, hips, knees, ankles and toes by the tree's shape.

    Parameters
    ----------
    tree : JointTree
    known : mapping of str to int
        Nodes that are known by this project's names; the shape must agree with them.

    Returns
    -------
    joints : dict of str to int

    Raises
    ------
    Unclear
        If the shape is not that of a person, or of several, if left and right cannot be told, or
        it contradicts what is known.
    """
    legs, arms = _legs_and_arms(tree, known)
    found: dict[str, int] = {}
    feet = [(limb.joints, limb.after) for limb in legs.limbs]
    left_leg, left_arm = left_one(tree, feet, [m.joints for m in arms.limbs], arms.top, known)
    for side, leg, arm in (
        ("left", legs.limbs[left_leg], arms.limbs[left_arm]),
        ("right", legs.limbs[1 - left_leg], arms.limbs[1 - left_arm]),
    ):
        nodes = (*leg.joints, leg.after, arm.before, *arm.joints)
        names = ("hip", "knee", "ankle", "toes", "collar", "shoulder", "elbow", "wrist")
        named = zip(names, nodes, strict=True)
        found |= {f"{side}_{name}": node for name, node in named if node is not None}
    for ours, node in known.items():
        if ours in found and found[ours] != node and not ours.endswith(("collar", "toes")):
            raise Unclear(
                f"{ours} would be '{tree.names[found[ours]]}' by its shape and "
                f"'{tree.names[node]}' by its name"
            )
    return found


def _pairs(tree: JointTree) -> list[_Pair]:
    """Pairs of long chains that branch off the same node and have the same bones."""
    reach = tree.reach
    pairs: list[tuple[float, int, tuple[int, ...], tuple[int, ...]]] = []
    shortest = SHORTEST_LIMB * reach.max(initial=0.0) / 3  # a root's reach has trunk and limb
    for j, children in enumerate(tree.children):
        long_ones = [c for c in children if reach[c] + tree.lengths[c] > shortest]
        for a, b in combinations(long_ones, 2):
            chains = _chain(tree, a, reach), _chain(tree, b, reach)
            if _alike(tree, *chains):
                pairs.append((reach[a] + tree.lengths[a], j, *chains))
    longest = max((length for length, *_ in pairs), default=0.0)
    pairs = [pair for pair in pairs if pair[0] >= SHORTEST_LIMB * longest]
    found = [_pair(tree, j, a, b, longest) for _, j, a, b in pairs]
    return [pair for pair in found if pair is not None]


def _pair(
    tree: JointTree, top: int, a: tuple[int, ...], b: tuple[int, ...], longest: float
) -> _Pair | None:
    """Find the two bones of both limbs; joints that never bend are left out if it needs that."""
    for straight_too in (True, False):
        first, second = (_limb(tree, chain, longest, straight_too) for chain in (a, b))
        if first is not None and second is not None and first.place == second.place:
            return _Pair(top, (first, second))
    return None


def _chain(tree: JointTree, j: int, reach: Array) -> tuple[int, ...]:
    """Nodes of the longest path from a node downwards."""
    chain = [j]
    while tree.children[chain[-1]]:
        chain.append(max(tree.children[chain[-1]], key=lambda c: reach[c] + tree.lengths[c]))
    return tuple(chain)


def _alike(tree: JointTree, a: tuple[int, ...], b: tuple[int, ...]) -> bool:
    """Whether two chains have the same number of bones of the same lengths."""
    if abs(len(a) - len(b)) > 1:  # one may lack its end
        return False
    both = np.array([(tree.lengths[i], tree.lengths[j]) for i, j in zip(a, b, strict=False)])
    slack = ALIKE * both.max(axis=1) + 0.03 * both.sum(axis=0).max()
    return bool((np.abs(both[:, 0] - both[:, 1]) <= slack).all())


def _limb(
    tree: JointTree, chain: tuple[int, ...], longest: float, straight_too: bool
) -> _Limb | None:
    """Find the two bones of a limb: the longest neighbours of about equal length."""
    nodes: list[int] = []
    for j in chain:  # of joints at one place the last is the one that turns
        if nodes and tree.lengths[j] < _TINY * longest and not tree.is_end(j):
            nodes[-1] = j
            continue
        nodes.append(j)
    if not straight_too:
        nodes, bending = _without_straight(tree, nodes)
    bones = [tree.distance(a, b) for a, b in pairwise(nodes)]
    options = [
        (upper + lower, k)
        for k, (upper, lower) in enumerate(pairwise(bones))
        if min(upper, lower) >= LIMB_RATIO * max(upper, lower)
    ]
    if not options:
        return None
    (length, k), *others = sorted(options, reverse=True)
    if any(other > 0.9 * length for other, _ in others) or max(bones) not in bones[k : k + 2]:
        return None  # more than two bones of one length: an upper arm of two parts, perhaps
    if not straight_too and not bending >= {nodes[k + 1], nodes[k + 2]}:
        return None  # a stiff wrist cannot be told from two parts of one bone
    before = nodes[k - 1] if k > 0 else None
    after = nodes[k + 3] if k + 3 < len(nodes) else None
    joints = nodes[k], nodes[k + 1], nodes[k + 2]
    return _Limb(joints, before, after, length, chain[0], tuple(map(chain.index, joints)))


def _without_straight(tree: JointTree, nodes: list[int]) -> tuple[list[int], set[int]]:
    """Leave out joints where the chain never bends, as parts of one bone; name those that do."""
    steps = np.diff(tree.positions[:, nodes], axis=1)
    steps /= np.maximum(np.linalg.norm(steps, axis=-1, keepdims=True), 1e-12)
    sine = np.linalg.norm(np.cross(steps[:, :-1], steps[:, 1:]), axis=-1)
    bend = np.degrees(np.arctan2(sine, np.sum(steps[:, :-1] * steps[:, 1:], axis=-1)))
    straight = bend.max(axis=0, initial=0.0) < STRAIGHT
    inner = [j for j, is_straight in zip(nodes[1:-1], straight, strict=True) if not is_straight]
    bends = np.ptp(bend, axis=0) > BENDS
    bending = {j for j, does in zip(nodes[1:-1], bends, strict=True) if does}
    return [nodes[0], *inner, nodes[-1]], bending


def _legs_and_arms(tree: JointTree, known: Mapping[str, int]) -> tuple[_Pair, _Pair]:
    """Tell legs from arms: one of them is known, or legs are longer and arms are at the head."""
    pairs = _pairs(tree)
    legs, arms = (_known_pair(tree, known, parts) for parts in (LEG, ARM))
    if legs is not None or arms is not None:
        taken = {j for pair in (legs, arms) if pair for limb in pair.limbs for j in limb.joints}
        others = [p for p in pairs if not taken & {j for limb in p.limbs for j in limb.joints}]
        if len(others) == 1:
            return legs or others[0], arms or others[0]
    if len(pairs) != 2:
        raise Unclear(
            "a person has two pairs of equal limbs of two long bones each, and it has "
            f"{len(pairs) or 'none'}"
        )
    legs, arms = sorted(pairs, key=lambda pair: -sum(limb.length for limb in pair.limbs))
    ratio = sum(m.length for m in legs.limbs) / sum(m.length for m in arms.limbs)
    if ratio < LEG_TO_ARM:
        raise Unclear("its four limbs are about equally long: which are the legs?")
    if legs.top == arms.top:
        return legs, arms
    head = [c for c in tree.children[arms.top] if c not in (m.first for m in arms.limbs)]
    head = [c for c in head if c != legs.top and not tree.is_below(legs.top, c)]
    if tree.common_ancestor(legs.top, arms.top) is None:
        raise Unclear("its arms and legs belong to different trees")
    if tree.is_below(legs.top, arms.top) and not head:
        raise Unclear("its arms would be at the root, and there is no head above them")
    return legs, arms


def _known_pair(tree: JointTree, known: Mapping[str, int], parts: tuple[str, ...]) -> _Pair | None:
    """Make a pair of limbs that are known already."""
    wanted = [part for part in parts if part not in OPTIONAL]
    limbs = []
    for side in ("left", "right"):
        joints = [known[f"{side}_{part}"] for part in wanted if f"{side}_{part}" in known]
        if len(joints) < len(wanted):
            return None
        first, middle, last = joints
        length = tree.distance(first, middle) + tree.distance(middle, last)
        limbs.append(_Limb((first, middle, last), None, None, length, first, ()))
    top = tree.common_ancestor(limbs[0].joints[0], limbs[1].joints[0])
    return None if top is None else _Pair(top, (limbs[0], limbs[1]))
