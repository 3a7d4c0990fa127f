"""The decision on blank masks, those without a person."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.errors import InputError
from silpose.core.types import Indices

BLANK = ("error", "nan")
"""What to do about a blank mask: refuse it, or answer with a row of NaN."""


def is_blank(mask: ArrayLike) -> bool:
    """Whether a mask (H, W) has no foreground."""
    return not np.any(mask)


def check_blank(blank: str) -> None:
    """Refuse what is not one of `BLANK`."""
    if blank not in BLANK:
        raise InputError(f"blank must be 'error' or 'nan', not '{blank}'")


def visible(
    masks: Sequence[ArrayLike], blank: str = "error", names: Sequence[str] | None = None
) -> Indices:
    """Find the masks with a person.

    Parameters
    ----------
    masks : sequence of array-like, each of shape (H, W)
        Not 0 is foreground.
    blank : {"error", "nan"}, default="error"
        Whether a mask without foreground is an error, or only left out.
    names : sequence of str, optional
        What the masks are called in errors; by default their indices.

    Returns
    -------
    indices : ndarray of int

    Raises
    ------
    InputError
        If a mask is blank and must not be; or if all masks are blank.
    """
    check_blank(blank)
    seen = np.array([not is_blank(mask) for mask in masks], dtype=bool)
    if blank == "error" and not seen.all():
        first = int(np.argmin(seen))
        name = f"'{names[first]}'" if names else str(first)
        raise InputError(
            f"mask {name} has no foreground: remove it, or ask for a row of NaN by "
            "silhouette.blank=nan (in Python blank='nan')"
        )
    if len(seen) and not seen.any():
        raise InputError(f"none of the {len(seen)} masks has a foreground: give masks of a person")
    return np.flatnonzero(seen)
