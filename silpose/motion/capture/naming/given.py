"""Names of joints that the user gives, `motion.joints`."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from itertools import pairwise, product

from silpose.core.errors import InputError
from silpose.core.skeleton import POINTS
from silpose.motion.capture.naming.limbs_by_name import ARM, LEG
from silpose.motion.capture.naming.tree import JointTree

Names = Mapping[str, Sequence[str]]
"""For each joint of the skeleton the names it may have, preferred first."""


def check_given(joints: Names | None) -> dict[str, tuple[str, ...]]:
    """Check names that a user gives; a name may stand for a list of one, a number for a name.

    Raises
    ------
    InputError
        If there is no such joint, or it is given no name.
    """
    if not isinstance(joints or {}, Mapping):
        raise InputError(
            f"motion.joints must be a mapping like {{left_elbow: [NAME]}}, not {joints}"
        )
    checked: dict[str, tuple[str, ...]] = {}
    for ours, names in (joints or {}).items():
        if ours not in POINTS:
            close = get_close_matches(str(ours), POINTS, n=1)
            known = f"did you mean '{close[0]}'?" if close else f"joints are {', '.join(POINTS)}"
            raise InputError(f"motion.joints has no joint '{ours}'; {known}")
        several = isinstance(names, Sequence) and not isinstance(names, str)
        given = [str(name) for name in (names if several else [names]) if name is not None]
        if not given or isinstance(names, Mapping):
            raise InputError(f"motion.joints gives {ours} no name: write {ours}: [NAME]")
        checked[ours] = tuple(given)
    return checked


def given_nodes(tree: JointTree, names: Names) -> tuple[dict[str, int], list[str]]:
    """Find the joints that have a given name.

    Parameters
    ----------
    tree : JointTree
    names : mapping of str to sequence of str

    Returns
    -------
    nodes : dict of str to int
    absent : list of str
        Joints of the skeleton none of whose given names the file has.

    Raises
    ------
    InputError
        If one joint of the file is given for two, or those of a limb are not below each other.
    """
    nodes: dict[str, int] = {}
    for ours, wanted in names.items():
        fits = (j for read in (str, _plain, _without_prefix) for name in wanted
                for j, theirs in enumerate(tree.names) if read(theirs) == read(name))  # fmt: skip
        if (node := next(fits, None)) is None:
            continue
        if other := next((o for o, j in nodes.items() if j == node), None):
            raise InputError(
                f"{tree.file}: motion.joints gives '{tree.names[node]}' for {other} and for {ours}"
            )
        nodes[ours] = node
    for limb in product(("left", "right"), (ARM, LEG)):
        own = [ours for part in limb[1] if (ours := f"{limb[0]}_{part}") in nodes]
        for above, below in pairwise(own):
            if not tree.is_below(nodes[below], nodes[above]):
                raise InputError(
                    f"{tree.file}: motion.joints gives '{tree.names[nodes[below]]}' for {below}, "
                    f"which is not below '{tree.names[nodes[above]]}' for {above} in the file"
                )
    return nodes, [ours for ours in names if ours not in nodes]


def _plain(name: str) -> str:
    """Leave out case, spaces and punctuation."""
    return re.sub(r"[\W_]", "", name).lower()


def _without_prefix(name: str) -> str:
    return _plain(re.split(r"[:|]", name)[-1])
