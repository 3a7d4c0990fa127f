"""What was probably meant by a name that does not exist."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches


def nearest(name: str, known: Iterable[str]) -> str:
    """Continue a sentence about an unknown name: by the nearest known one, else by all.

    Parameters
    ----------
    name : str
        Such as ``"motion.secnds"``; only names of the same group are compared with it.
    known : iterable of str

    Returns
    -------
    words : str
        ``"; did you mean …?"`` or ``"; there are …"``.
    """
    known = list(known)
    group, dot, last = name.rpartition(".")
    beside = [k.rpartition(".")[2] for k in known if k.rpartition(".")[0] == group]
    if not beside:  # the group itself is misspelt
        group, dot, last, beside = "", "", name, known
    if close := get_close_matches(last, beside, n=1):
        return f"; did you mean '{group}{dot}{close[0]}'?"
    return f"; there are {', '.join(sorted(beside))}"
