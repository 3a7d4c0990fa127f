"""Names of the methods of single-image regression: ``ridge``, ``rvm``, ``rvm_N``, ``svm``."""

from __future__ import annotations

import re
from collections.abc import Sequence

from silpose.core.errors import InputError

METHODS = ("ridge", "rvm", "rvm_N (at most N % kept)", "svm")


def check_methods(methods: Sequence[str]) -> None:
    """Refuse unknown names, before hours are spent on the others.

    Raises
    ------
    InputError
        If a name is no method.
    """
    for method in methods:
        share(method)


def share(method: str) -> float | None:
    """Return the share of kernels that a method's name allows, or None if it names none."""
    if method in ("ridge", "rvm", "svm"):
        return None
    percent = re.fullmatch(r"rvm_(\d+)", method)
    if not percent or not 0 < int(percent[1]) <= 100:
        raise InputError(f"there is no method '{method}'; there are {', '.join(METHODS)}")
    return int(percent[1]) / 100
