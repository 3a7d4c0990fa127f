"""Which joint of a file is which joint of the skeleton."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product

from silpose.core.errors import InputError
from silpose.core.skeleton import POINTS
from silpose.motion.capture.naming.agreement import doubt_about, is_of_another
from silpose.motion.capture.naming.by_shape import limbs_by_shape
from silpose.motion.capture.naming.given import Names, check_given, given_nodes
from silpose.motion.capture.naming.limbs_by_name import (
    ARM,
    LEG,
    OPTIONAL,
    is_ambiguous,
    limb_by_name,
)
from silpose.motion.capture.naming.places import ends, limb_by_place
from silpose.motion.capture.naming.sides import Unclear
from silpose.motion.capture.naming.tree import JointTree
from silpose.motion.capture.naming.trunk import find_trunk
from silpose.motion.capture.naming.wording import (
    absent_in_words,
    not_found,
    shape_in_words,
    two_people,
    unequal_bones,
)
from silpose.motion.capture.raw_motion import RawMotion

_SIDES = ("left", "right")
_PARTS = (*ARM, *LEG)


@dataclass(frozen=True)
class Matched:
    """Joints of a file by the names of the skeleton's.

    Attributes
    ----------
    joints : mapping of str to int
        Nodes of the file; root and the twelve joints of arms and legs are always there, the others
        if the file has them. A wrist or an ankle may be an end site.
    how : mapping of str to str
        ``given``, ``by name``, ``by place`` (the tree leaves no other) or ``by shape``.
    notes : tuple of str
        Doubts, one sentence each.
    """

    joints: Mapping[str, int]
    how: Mapping[str, str]
    notes: tuple[str, ...] = ()


def match(raw: RawMotion, given: Names | None = None) -> Matched:
    """Match the joints of a file to the skeleton's: by names, if the tree agrees, else by shape.

    Parameters
    ----------
    raw : RawMotion
    given : mapping of str to sequence of str or None, default=None
        Names that the user gives, in place of those that are known.

    Returns
    -------
    matched : Matched

    Raises
    ------
    InputError
        If a joint of an arm or a leg cannot be found, or what is given contradicts the tree.
    """
    tree = JointTree(raw)
    fixed, absent = given_nodes(tree, check_given(given))
    found, doubts = _limbs(tree, fixed)
    notes = []
    if doubts or _missing(found):
        try:
            by_shape = limbs_by_shape(tree, {ours: node for ours, (node, _) in found.items()})
        except Unclear as unclear:
            raise not_found(tree, _missing(found), doubts, str(unclear)) from None
        by_shape = {ours: node for ours, node in by_shape.items() if ours not in found}
        found |= {ours: (node, "by shape") for ours, node in by_shape.items()}
        notes.append(shape_in_words(tree, by_shape))
    _check_one_tree(tree, found)
    limbs = {ours: node for ours, (node, _) in found.items() if ours.partition("_")[2] in _PARTS}
    found |= find_trunk(tree, limbs, fixed)
    for ours, node in ends(tree, {ours: node for ours, (node, _) in found.items()}).items():
        found.setdefault(ours, (node, "by place"))
    ordered = [ours for ours in POINTS if ours in found]
    joints = {ours: found[ours][0] for ours in ordered}
    notes += absent_in_words(tree, absent, joints) + unequal_bones(tree, joints)
    return Matched(joints, {ours: found[ours][1] for ours in ordered}, tuple(notes))


def _limbs(
    tree: JointTree, given: Mapping[str, int]
) -> tuple[dict[str, tuple[int, str]], list[str]]:
    """Find arms and legs by names, without those limbs where the tree disagrees, and why."""
    found: dict[str, tuple[int, str]] = {ours: (node, "given") for ours, node in given.items()}
    doubts = []
    for side, parts in product(_SIDES, (ARM, LEG)):
        limb = limb_by_name(tree, side, parts, given)
        how = dict.fromkeys(limb, "by name") | dict.fromkeys(given, "given")
        by_place = limb_by_place(tree, side, parts, limb)
        how |= dict.fromkeys(by_place, "by place")
        limb |= by_place
        wanted = [f"{side}_{part}" for part in parts if part not in OPTIONAL]
        whole = all(ours in limb for ours in wanted)
        doubt = doubt_about(tree, side, parts, limb, given)
        if whole and "root" not in given:
            required = {ours: limb[ours] for ours in wanted}
            other = limb_by_name(tree, side, parts, given, set(limb.values()))
            if is_of_another(tree, required, other):
                raise two_people(tree, wanted[0], limb, other)
        if doubt:
            doubts.append(doubt)
            continue
        found |= {
            ours: (node, how[ours])
            for ours, node in limb.items()
            if whole or how[ours] == "given" or not is_ambiguous(tree.words[node].word)
        }
    return found, doubts


def _missing(found: Mapping[str, object]) -> list[str]:
    wanted = [f"{side}_{part}" for side in _SIDES for part in (*ARM, *LEG) if part not in OPTIONAL]
    return [ours for ours in wanted if ours not in found]


def _check_one_tree(tree: JointTree, found: Mapping[str, tuple[int, str]]) -> None:
    limbs = {ours: node for ours, (node, _) in found.items()}
    first = limbs["left_hip"]
    for ours, node in limbs.items():
        if tree.lineage(node)[-1] != tree.lineage(first)[-1]:
            raise InputError(
                f"{tree.file}: '{tree.names[node]}' ({ours}) and '{tree.names[first]}' (left_hip) "
                "belong to different trees of joints; export one person with one root"
            )
