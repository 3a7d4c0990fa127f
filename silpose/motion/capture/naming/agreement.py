"""Whether the tree agrees with the names by which a limb was found."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from itertools import pairwise

from silpose.motion.capture.naming.tree import JointTree

RATIO, RATIO_TO_UNKNOWN = 0.35, 0.55
"""Smallest ratio of the lengths of a limb's bones, and where a joint of unknown name follows."""

AWAY = 0.12
"""Distance by which a joint lies within a bone and not at its end, relative to the bone."""


def doubt_about(
    tree: JointTree,
    side: str,
    parts: tuple[str, ...],
    joints: Mapping[str, int],
    given: Collection[str],
) -> str:
    """Say why the joints of a limb may be others than their names say.

    Parameters
    ----------
    tree : JointTree
    side : {"left", "right"}
    parts : tuple of str
        Those of `silpose.motion.capture.naming.limbs_by_name.limb_by_name`.
    joints : mapping of str to int
    given : collection of str
        Joints that the user names, which are not doubted.

    Returns
    -------
    reason : str
        Empty if the tree agrees.
    """
    own = [ours for part in parts if (ours := f"{side}_{part}") in joints and part != "toes"]
    for above, below in pairwise(own):
        if above in given and below in given:
            continue
        if (unknown := _unknown_between(tree, joints[above], joints[below])) is not None:
            return (
                f"'{tree.names[unknown]}', whose name is unknown, is between "
                f"'{tree.names[joints[above]]}' and '{tree.names[joints[below]]}'"
            )
    limb = [joints[ours] for ours in own if not ours.endswith("collar")]
    nodes = [joints[ours] for ours in own]
    if len(own) > 1 and own[0] not in given and (reason := _doubt_about_first(tree, *nodes[:2])):
        return reason
    if len(limb) == 3 and not set(own) <= set(given):
        upper, lower = (tree.distance(a, b) for a, b in pairwise(limb))
        strange = any(_is_unknown(tree, child) for child in tree.children[limb[-1]])
        ratio = RATIO_TO_UNKNOWN if strange else RATIO
        if min(upper, lower) < ratio * max(upper, lower):
            first, middle, last = (f"'{tree.names[j]}'" for j in limb)
            return (
                f"{first} to {middle} is {upper:.3g} long and {middle} to {last} {lower:.3g}, "
                "which are no two bones of one limb"
            )
    return ""


def is_of_another(tree: JointTree, limb: Mapping[str, int], other: Mapping[str, int]) -> bool:
    """Whether a second limb of the same names is another person's, and no copy of the first."""
    if not set(limb) <= set(other):
        return False
    if any(tree.is_below(a, b) for name, j in limb.items() for a, b in
           ((j, other[name]), (other[name], j))):  # fmt: skip
        return False
    length = tree.distance(*list(limb.values())[:2])
    return any(tree.distance(j, other[name]) > AWAY * length for name, j in limb.items())


def _unknown_between(tree: JointTree, above: int, below: int) -> int | None:
    """Find a joint of unknown name that lies within the bone between two joints."""
    length = tree.distance(above, below)
    for j in tree.between(above, below):
        if _is_unknown(tree, j) and min(tree.distance(above, j), tree.distance(j, below)) > (
            AWAY * length
        ):
            return j
    return None


def _doubt_about_first(tree: JointTree, j: int, below: int) -> str:
    """Doubt a second part of a bone, if the joint above it has an unknown name."""
    word, above = tree.words[j], tree.parents[j]
    if above < 0 or not _is_unknown(tree, above):
        return ""
    if word.number and tree.lengths[j] > RATIO_TO_UNKNOWN * tree.distance(j, below):
        return f"'{tree.names[above]}', whose name is unknown, is above '{tree.names[j]}'"
    return ""


def _is_unknown(tree: JointTree, j: int) -> bool:
    return not tree.words[j].word and not tree.words[j].helper and not tree.is_end(j)
