"""Doubts and refusals of a match, in words."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from silpose.core.errors import InputError
from silpose.motion.capture.naming.tree import JointTree

MOST_NAMES = 80
"""Names of joints that an error lists."""

UNEQUAL = 0.3
"""Difference of a left and a right bone that is doubted, relative to the longer."""

_SIDES = ("left", "right")
_BONES = (("hip", "knee"), ("knee", "ankle"), ("shoulder", "elbow"), ("elbow", "wrist"))


def two_people(
    tree: JointTree, ours: str, limb: Mapping[str, int], other: Mapping[str, int]
) -> InputError:
    """Make the error about two people in one file."""
    a, b = (f"'{tree.names[nodes[ours]]}'" for nodes in (limb, other))
    return InputError(
        f"{tree.file}: both {a} and {b} may be {ours}: of two people choose one by the joint "
        "between the hips, 'motion.joints={root: [NAME]}', in Python joints={'root': ['NAME']}"
    )


def not_found(
    tree: JointTree, missing: Sequence[str], doubts: Sequence[str], reason: str
) -> InputError:
    """Make the error about joints that neither names nor shape tell.

    Parameters
    ----------
    tree : JointTree
    missing : sequence of str
        Joints of the skeleton.
    doubts : sequence of str
        Why names do not tell.
    reason : str
        Why the shape does not.
    """
    names = [name for j, name in enumerate(tree.names) if not tree.is_end(j)]
    more = f" and {len(names) - MOST_NAMES} more" if len(names) > MOST_NAMES else ""
    why = f" ({'; '.join(doubts)})" if doubts else ""
    return InputError(
        f"{tree.file}: names do not tell {', '.join(missing)}{why}, nor does the shape ({reason}); "
        f"its joints are {', '.join(names[:MOST_NAMES])}{more}: name them by "
        f"'motion.joints={{{missing[0]}: [NAME]}}', in Python joints={{'{missing[0]}': ['NAME']}}"
    )


def shape_in_words(tree: JointTree, joints: Mapping[str, int]) -> str:
    """Say which joints were found by shape."""
    own = ", ".join(f"{ours} '{tree.names[j]}'" for ours, j in joints.items())
    return (
        f"these joints were found by the shape of the skeleton, as names do not tell them: {own}; "
        "if one is wrong, motion.joints names another"
    )


def absent_in_words(
    tree: JointTree, absent: Collection[str], joints: Mapping[str, int]
) -> list[str]:
    """Say which joints were named that the file does not have, and what was taken instead."""
    return [
        f"it has no joint of the name that motion.joints gives for {ours}; "
        + (f"'{tree.names[joints[ours]]}' was taken" if ours in joints else "it goes without")
        for ours in absent
    ]


def unequal_bones(tree: JointTree, joints: Mapping[str, int]) -> list[str]:
    """Doubt joints by which a left and a right bone have different lengths."""
    doubts = []
    for start, end in _BONES:
        ends = [(joints[f"{side}_{start}"], joints[f"{side}_{end}"]) for side in _SIDES]
        left, right = (tree.distance(*pair) for pair in ends)
        if abs(left - right) > UNEQUAL * max(left, right):
            (a, b), (c, d) = [[f"'{tree.names[j]}'" for j in pair] for pair in ends]
            doubts.append(
                f"{start} to {end} is {left:.3g} long on the left ({a} to {b}) and {right:.3g} on "
                f"the right ({c} to {d}): if these are the wrong joints, motion.joints names others"
            )
    return doubts
