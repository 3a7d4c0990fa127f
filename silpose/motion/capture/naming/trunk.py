"""Root, chest, neck and head: by where arms and legs branch off, and by names."""

from __future__ import annotations

from collections.abc import Mapping

from silpose.core.errors import InputError
from silpose.motion.capture.naming.tree import JointTree
from silpose.motion.capture.naming.words import joint_words

_PAIR = 0.05  # largest difference of the sizes of a left and a right part

By = tuple[int, str]
"""A node, and how it was found."""


def find_trunk(
    tree: JointTree, limbs: Mapping[str, int], given: Mapping[str, int]
) -> dict[str, By]:
    """Find root, chest, neck and head of a person whose limbs are known.

    Parameters
    ----------
    tree : JointTree
    limbs : mapping of str to int
        Nodes of hips and shoulders, perhaps collars, by this project's names.
    given : mapping of str to int
        Nodes of joints that the user names.

    Returns
    -------
    joints : dict of str to (int, str)
        Those that the file has, and how they were found.

    Raises
    ------
    InputError
        If a root or a chest is given that is not above hips or arms.
    """
    hips = tree.common_ancestor(limbs["left_hip"], limbs["right_hip"])
    arms = [limbs.get(f"{s}_collar", limbs[f"{s}_shoulder"]) for s in ("left", "right")]
    top = tree.common_ancestor(*arms)
    assert hips is not None and top is not None  # of one tree, as the match has checked
    for ours, node in (("root", hips), ("chest", top)):
        if ours in given and given[ours] not in tree.lineage(node):
            raise InputError(
                f"{tree.file}: motion.joints gives '{tree.names[given[ours]]}' for {ours}, which "
                f"is not above both {'hips' if ours == 'root' else 'arms'} in the file"
            )
    found = {"root": (given["root"], "given") if "root" in given else _root(tree, hips, top)}
    root = found["root"][0]
    chest = top
    while chest != root and _says(tree, chest, "neck") and tree.parents[chest] >= 0:
        chest = tree.parents[chest]  # of a Biped, whose collars are on the neck
    if "chest" in given:
        found["chest"] = given["chest"], "given"
    elif chest != root and not (tree.is_below(root, chest) and hips == chest):
        found["chest"] = chest, "by name" if _says(tree, chest, "trunk") else "by place"
    return found | _neck_and_head(tree, chest, top, set(limbs.values()), given)


def _root(tree: JointTree, hips: int, top: int) -> By:
    """Find the joint that carries both legs; if it carries the arms too, the pelvis above it."""
    if hips == top or tree.is_below(top, hips):
        for j in tree.lineage(hips):
            if _says(tree, j, "root"):
                return j, "by name"
    return hips, "by name" if _says(tree, hips, "root") else "by place"


def _neck_and_head(
    tree: JointTree, chest: int, top: int, limbs: set[int], given: Mapping[str, int]
) -> dict[str, By]:
    found: dict[str, By] = {}
    above = [j for j in tree.below(chest) if not _is_of_limb(tree, j, limbs, top)]
    if "head" in given:
        found["head"] = given["head"], "given"
    else:
        named = [j for j in above if _says(tree, j, "head") and not tree.is_end(j)]
        named.sort(key=lambda j: (tree.words[j].helper, tree.words[j].partly, j))
        if named and not tree.words[named[0]].helper:
            found["head"] = named[0], "by name"
    if "neck" in given:
        found["neck"] = given["neck"], "given"
        return found
    if "head" in found and tree.is_below(found["head"][0], chest):
        between = tree.between(chest, found["head"][0])
    else:
        between = _spine_above(tree, chest, above)
        if len(between) > 1:
            found["head"] = between.pop(), "by place"
    words = joint_words()["neck"]
    named = [j for j in between if tree.words[j].word in words]
    if named:
        found["neck"] = min(named, key=lambda j: _preference(tree, j)), "by name"
    elif between:
        found["neck"] = between[0], "by place"
    return found


def _spine_above(tree: JointTree, chest: int, above: list[int]) -> list[int]:
    """List the joints above the chest, of a file that names no head, up to one that turns."""
    chain: list[int] = []
    node = _middle_child(tree, chest, above)
    while node is not None:
        chain.append(node)
        node = _middle_child(tree, node, above)
    turning = [k for k, j in enumerate(chain) if tree.turns[j]]
    return chain[: turning[-1] + 1] if turning else chain


def _middle_child(tree: JointTree, j: int, above: list[int]) -> int | None:
    """Child in the middle of the body: the largest, and not one of a left and a right one."""
    children = [c for c in tree.children[j] if c in above and not tree.is_end(c)]
    children = [c for c in children if not tree.words[c].side and not _is_of_face(tree, c)]
    sizes = {c: tree.lengths[c] + tree.reach[c] for c in children}
    for c in sorted(children, key=lambda c: -sizes[c]):
        if not any(abs(sizes[c] - sizes[o]) < _PAIR * sizes[c] for o in children if o != c):
            return c
    return None


def _is_of_face(tree: JointTree, j: int) -> bool:
    return tree.words[j].word in joint_words()["other"]


def _is_of_limb(tree: JointTree, j: int, limbs: set[int], top: int) -> bool:
    """Whether a node belongs to an arm or a leg, or to the path to a hip."""
    if j in limbs or any(tree.is_below(j, limb) for limb in limbs):
        return True
    return j != top and any(tree.is_below(limb, j) for limb in limbs)


def _says(tree: JointTree, j: int, what: str) -> bool:
    """Whether a joint's name has a word for something in the middle of the body."""
    word = tree.words[j]
    return not word.side and word.word in joint_words()[what]


def _preference(tree: JointTree, j: int) -> tuple[bool, int, bool, int]:
    """Order of joints that are called neck: with number 1 before without before other numbers."""
    word = tree.words[j]
    order = {1: 0, None: 1}.get(word.number, 2)
    return word.helper or word.partly, joint_words()["neck"].index(word.word), order > 1, order
