"""Order of names by the numbers in them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

_NUMBER = re.compile(r"(\d+(?:\.\d+)?)")
_LAST_COUNT = re.compile(r"(.*\d.*?)(?<!\d)(\d+)(\D*)")  # behind another number
_SIGNED = re.compile(r"(.*?)(-?)(\d+(?:\.\d+)?)(\D*)")  # the last number, and a sign
_LEAST_STRETCH = 3  # names that count up, at least, to be a take


def in_natural_order(names: Sequence[str]) -> list[int]:
    """Order names by their numbers, 2 before 10 and 0.9 before 1.

    What follows a dot are decimals (0.25 before 0.3), unless the names count there (1.9 before
    1.10): decimals of different lengths do not end in zero. Negative numbers come first (t-2
    before t-1 and t0).

    Parameters
    ----------
    names : sequence of str
        Without suffixes.

    Returns
    -------
    order : list of int
        Indices of the names.
    """
    counted = _counts_after_dots(names)
    plain, below = without_signs(names)
    keys = [_key(*own, counted) for own in zip(names, plain, below, strict=True)]
    return sorted(range(len(names)), key=keys.__getitem__)


def without_numbers(name: str) -> str:
    """Replace the numbers in a name: what is the same for all frames of a take."""
    return _NUMBER.sub("#", name)


def kinds_of_names(names: Sequence[str]) -> list[str]:
    """Replace the numbers in names, and the signs of those that count from below zero."""
    return [without_numbers(name) for name in without_signs(names)[0]]


def takes_among(names: Sequence[str]) -> list[int]:
    """Find where names count anew, such as cam1_0, cam1_1, cam1_2, cam2_0 and so on.

    Parameters
    ----------
    names : sequence of str
        In natural order, without suffixes.

    Returns
    -------
    starts : list of int
        First name of each of several takes; empty if there is one only, or no such order.
    """
    found = [_LAST_COUNT.fullmatch(name) for name in names]
    if not names or not all(found):
        return []
    heads = [match[1] + match[3] for match in found if match]
    counts = [int(match[2]) for match in found if match]
    starts = [k for k in range(len(names)) if k == 0 or heads[k] != heads[k - 1]]
    stretches = [counts[a:b] for a, b in pairwise([*starts, len(names)])]
    steps = {b - a for own in stretches for a, b in pairwise(own)}
    same = len({own[0] for own in stretches}) == 1 and len(steps) == 1
    enough = min(map(len, stretches)) >= _LEAST_STRETCH
    return starts if len(starts) > 1 and same and enough else []


def without_signs(names: Sequence[str]) -> tuple[list[str], list[bool]]:
    """Take away the signs of last numbers, and say which names had one.

    A sign is told from a hyphen: among names that are alike, there is a zero without one only.
    """
    found = [_SIGNED.fullmatch(name) for name in names]
    zeros = {(m[1], m[2], m[4]) for m in found if m and not float(m[3])}
    plain, below = list(names), [False] * len(names)
    for k, m in enumerate(found):
        if m and m[2] and (m[1], "", m[4]) in zeros and (m[1], "-", m[4]) not in zeros:
            plain[k], below[k] = m[1] + m[3] + m[4], True
    return plain, below


def _counts_after_dots(names: Sequence[str]) -> bool:
    decimals = [n.split(".")[1] for name in names for n in _NUMBER.findall(name) if "." in n]
    lengths = {len(digits) for digits in decimals}
    return len(lengths) > 1 and any(digits.endswith("0") for digits in decimals)


def _key(
    name: str, plain: str, below_zero: bool, counted: bool
) -> list[tuple[str, float, float, str]]:
    """Text and numbers of a name without its sign in turn: each text, then the number behind it."""
    parts = _NUMBER.split(plain)
    key = []
    for text, number in zip(parts[::2], [*parts[1::2], ""], strict=True):
        whole, _, decimals = number.partition(".")
        after = float(decimals or -1) if counted else float(f"0.{decimals or 0}")
        key.append((text.casefold(), float(whole or -1), after, number))
    if below_zero:
        text, whole_number, after, number = key[-2]
        key[-2] = (text, -whole_number, -after, number)
    return [*key, (name, 0.0, 0.0, "")]
