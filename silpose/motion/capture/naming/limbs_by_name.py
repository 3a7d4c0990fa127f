"""Arms and legs by the names of their joints, where the tree agrees."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from itertools import pairwise, product

from silpose.motion.capture.naming.tree import JointTree
from silpose.motion.capture.naming.words import joint_words

ARM = ("collar", "shoulder", "elbow", "wrist")
LEG = ("hip", "knee", "ankle", "toes")
OPTIONAL = ("collar", "toes")
"""Joints of a limb that a file may lack."""

_BEST, _RANK, _PARTLY, _GIVEN = 100.0, 6.0, 120.0, 1000.0
_MISSING = -200.0  # of a joint that a limb must have
_OF_ASF = ("humerus", "radius")
_MOST = 7  # names that are tried for one joint


def limb_by_name(
    tree: JointTree,
    side: str,
    parts: tuple[str, ...],
    given: Mapping[str, int],
    others: Collection[int] = (),
) -> dict[str, int]:
    """Match the joints of a limb, each below the one before it.

    Parameters
    ----------
    tree : JointTree
    side : {"left", "right"}
    parts : tuple of str
        `ARM` or `LEG`.
    given : mapping of str to int
        Nodes of joints that the user names, which are kept; below a root that is given is all else.
    others : collection of int, default=()
        Nodes that are left out.

    Returns
    -------
    joints : dict of str to int
        Nodes by this project's names, ``left_elbow``; those that no name fits are missing.
    """
    options: list[list[tuple[float, int | None]]] = []
    for part in parts:
        ours = f"{side}_{part}"
        if ours in given:
            options.append([(_GIVEN, given[ours])])
            continue
        fits = [fit for fit in _named(tree, side, part) if fit[1] not in others]
        if "root" in given:
            fits = [fit for fit in fits if tree.is_below(fit[1], given["root"])]
        fits = sorted(fits, key=lambda fit: (-fit[0], fit[1]))[:_MOST]
        options.append([*fits, (0.0 if part in OPTIONAL else _MISSING, None)])
    best: tuple[float, ...] = ()
    chosen: tuple[int | None, ...] = ()
    for choice in product(*options):
        nodes = [node for _, node in choice if node is not None]
        if not all(tree.is_below(b, a) for a, b in pairwise(nodes)):
            continue
        # of equals the nearest to the root, so that a joint is taken and not its end
        score = (sum(points for points, _ in choice), *(-tree.depths[n] for n in nodes))
        if score > best:
            best, chosen = score, tuple(node for _, node in choice)
    found = zip(parts, chosen, strict=False)
    return {f"{side}_{part}": node for part, node in found if node is not None}


def is_ambiguous(word: str) -> bool:
    """Whether a word may stand for several joints of a limb, which the other joints decide."""
    return sum(word in joint_words()[part] for part in (*ARM, *LEG)) > 1


def _named(tree: JointTree, side: str, part: str) -> list[tuple[float, int]]:
    """Nodes that a joint's name fits, with how well."""
    words = list(joint_words()[part])
    if part == "wrist" and any(w.word in _OF_ASF for w in tree.words):
        words.insert(0, "hand")  # a forearm is of two parts there, radius and wrist
    found = []
    for j, word in enumerate(tree.words):
        if word.side == side and word.word in words and not word.helper:
            points = _BEST - _RANK * words.index(word.word) - _PARTLY * word.partly
            found.append((points - min(word.number or 0, 9) / 10, j))
    return found
