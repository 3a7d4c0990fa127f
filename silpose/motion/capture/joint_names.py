"""Recognition of a file's joints by their names."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path

import yaml

from silpose.core.errors import InputError

Names = Mapping[str, Sequence[str]]

OPTIONAL = (
    "chest", "neck", "head", "left_collar", "right_collar", "left_hand", "right_hand",
)  # fmt: skip
"""Joints that a file may lack: they then move with their parents."""


@cache
def common_names() -> Names:
    """Read the table ``joint_names.yaml`` beside this file: joints of the skeleton, and names."""
    table = Path(__file__).with_name("joint_names.yaml")
    names: dict[str, list[str]] = yaml.safe_load(table.read_text(encoding="utf-8"))
    return names


def match_joints(found: Sequence[str], names: Names, file: str) -> dict[str, str]:
    """Match the joints of the skeleton to those of a file.

    Parameters
    ----------
    found : sequence of str
        Names of the file's joints.
    names : mapping of str to sequence of str
        For each joint of the skeleton the names it may have, in order of preference.
    file : str
        Named in the error.

    Returns
    -------
    joints : dict of str to str
        Joint of the skeleton to joint of the file.

    Raises
    ------
    InputError
        If joints are missing; it lists them, and those that were found.
    """
    plain = [_plain(name) for name in found]
    prefix = _common_beginning(plain)
    by_name: dict[str, str] = {}
    for name, short in zip(found, plain, strict=True):
        by_name.setdefault(short.removeprefix(prefix), name)
    joints: dict[str, str] = {}
    for ours, known in names.items():
        fits = (by_name[_plain(n)] for n in known if _plain(n) in by_name)
        free = next((name for name in fits if name not in joints.values()), None)
        if free is not None:
            joints[ours] = free
    missing = [ours for ours in names if ours not in joints and ours not in OPTIONAL]
    if missing:
        wanted = ", ".join(f"{ours} ({' or '.join(names[ours][:3])} …)" for ours in missing)
        raise InputError(
            f"{file}: cannot find {wanted} among its joints {', '.join(found)}; add the names they "
            f"have there, such as 'motion.joints={{{missing[0]}: [NAME]}}'"
        )
    return joints


def _common_beginning(words: Sequence[str]) -> str:
    if len(words) < 2:
        return ""
    first, last = min(words), max(words)
    same = (k for k, (a, b) in enumerate(zip(first, last, strict=False)) if a != b)
    return first[: next(same, len(first))]


def _plain(name: str) -> str:
    """Remove a namespace, case, spaces and punctuation."""
    return re.sub(r"[\W_]", "", name.rpartition(":")[2]).lower()
