"""Joints without a known name whose place in the tree leaves no other: within limbs, and ends."""

from __future__ import annotations

from collections.abc import Mapping

from silpose.motion.capture.naming.tree import JointTree
from silpose.motion.capture.naming.words import joint_words


def limb_by_place(
    tree: JointTree, side: str, parts: tuple[str, ...], known: Mapping[str, int]
) -> dict[str, int]:
    """Find a limb's middle joint, if there is one only, or its last, if it is an end site.

    Parameters
    ----------
    tree : JointTree
    side : {"left", "right"}
    parts : tuple of str
        Those of `silpose.motion.capture.naming.limbs_by_name.limb_by_name`.
    known : mapping of str to int

    Returns
    -------
    joints : dict of str to int
        Of those that are not known.
    """
    first, middle, last = (f"{side}_{part}" for part in parts if part not in ("collar", "toes"))
    if first in known and last in known and middle not in known:
        between = tree.between(known[first], known[last])
        if len(between) == 1 and not tree.words[between[0]].word:
            return {middle: between[0]}
    if first in known and middle in known and last not in known:
        children = [j for j in tree.children[known[middle]] if tree.lengths[j] > 0]
        if len(children) == 1 and tree.is_end(children[0]):
            return {last: children[0]}
    return {}


def ends(tree: JointTree, joints: Mapping[str, int]) -> dict[str, int]:
    """Find the hands, the toes and the top of the head.

    Parameters
    ----------
    tree : JointTree
    joints : mapping of str to int
        All other joints.

    Returns
    -------
    joints : dict of str to int
        Joints or end sites; those that the file has.
    """
    found: dict[str, int | None] = {}
    for side in ("left", "right"):
        found[f"{side}_hand"] = _knuckle(tree, side, joints[f"{side}_wrist"])
        found[f"{side}_toes"] = tree.main_child(joints[f"{side}_ankle"])
    if "head" in joints:
        found["head_top"] = next(
            (j for j in tree.children[joints["head"]] if tree.is_end(j) and tree.lengths[j] > 0),
            None,
        )
    return {ours: node for ours, node in found.items() if node is not None}


def _knuckle(tree: JointTree, side: str, wrist: int) -> int | None:
    """Where a hand points: the first joint of the middle finger, else of another."""
    words = joint_words()["hand"]
    named = [
        j
        for j in tree.below(wrist)
        if tree.words[j].word in words
        and tree.words[j].side == side
        and (tree.words[j].number or 0) <= 1
        and tree.distance(wrist, j) > 0
        and not tree.words[j].helper
    ]
    named.sort(
        key=lambda j: (
            tree.words[j].partly,
            tree.words[j].word == "finger" and tree.words[j].number == 0,  # a Biped's thumb
            words.index(tree.words[j].word),
            j,
        )
    )
    return named[0] if named else tree.main_child(wrist)
