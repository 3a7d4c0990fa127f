"""What may be wrong with all masks of a source, in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from silpose.core.types import Mask
from silpose.silhouette.person.facts import MaskFacts
from silpose.silhouette.person.selector import lowest_person

UPRIGHT = (1.3, 5.0)
"""Lowest and highest aspect, height over width, that half of an upright person's masks have."""

_BORDER = 2.01  # pixels to a box that fills the frame
_ENOUGH = 3  # masks from which equal crops are no coincidence


def why_nobody(masks: Sequence[Mask], facts: MaskFacts, called: str) -> str:
    """Say why no mask of a source shows a person.

    Parameters
    ----------
    masks : sequence of ndarray, each (H, W)
    facts : MaskFacts
        None of them `seen`.
    called : str
        `` in SOURCE``, or nothing.
    """
    count = len(masks)
    if facts.blank.all():
        return f"none of the {count} masks{called} has a foreground: give masks of a person"
    if facts.filled.sum() >= facts.fragment.sum():
        return (
            f"the foreground fills the whole frame in {int(facts.filled.sum())} of {count} "
            f"masks{called}, and no other shows a person: give masks with the person in the "
            "foreground and the rest of the frame in the background"
        )
    largest = max(int(np.count_nonzero(mask)) for mask in masks)
    lowest = lowest_person(max(mask.shape[0] for mask in masks))
    return (
        f"none of the {count} masks{called} shows a person, only pieces of at most {largest} "
        f"pixels: give masks with a person at least {np.ceil(lowest):.0f} pixels high"
        + (", or crop them around the person" if lowest > lowest_person(1) else "")
    )


def switching(person: str, switches: int, masks: int, called: str) -> str:
    """Doubt a choice by frame that falls on one person now, and on another then.

    Parameters
    ----------
    person : str
        ``"largest"``, ``"left"`` or ``"right"``.
    switches, masks : int
        Frames in which another person was chosen than before, and all.
    called : str
        `` in SOURCE``, or nothing.
    """
    which = "the largest one" if person == "largest" else f"the one on the {person}"
    return (
        f"of several people{called}, {which} is another one than before in {switches} of {masks} "
        "masks: to follow one person, give silhouette.person=tracked or a number, counted from the "
        "left (in Python person='tracked' or person=1)"
    )


def doubts_about(masks: Sequence[Mask], facts: MaskFacts, called: str) -> tuple[str, ...]:
    """Doubt proportions that no upright person has.

    Parameters
    ----------
    masks : sequence of ndarray, each (H, W)
        Of one person.
    facts : MaskFacts
        Of these masks, some of them `seen`.
    called : str
        `` in SOURCE``, or nothing.

    Returns
    -------
    doubts : tuple of str
        A sentence each.
    """
    seen = np.flatnonzero(facts.seen)
    frames = np.array([masks[frame].shape[:2] for frame in seen.tolist()])
    boxes = np.stack([facts.height, facts.height / facts.aspect], axis=1)[seen]
    full = np.abs(boxes - frames).max() <= _BORDER and (frames == frames[0]).all()
    if full and len(seen) >= _ENOUGH:
        height, width = frames[0]
        return (
            f"the person fills all {len(seen)} masks{called} from border to border, "
            f"{width} x {height} pixels each: were they stretched to one size? Scale crops by one "
            "factor in both directions",
        )
    whole = facts.seen & ~facts.cut
    aspect = float(np.median(facts.aspect[whole])) if whole.any() else UPRIGHT[0]
    if UPRIGHT[0] <= aspect <= UPRIGHT[1]:
        return ()
    if aspect < 1 / UPRIGHT[0]:
        shape = "turned by a quarter (np.rot90 turns arrays), or stretched to the sides"
    else:
        shape = "stretched to the sides" if aspect < UPRIGHT[0] else "squeezed from the sides"
    return (
        f"the person{called} is {aspect:.1f} times as high as wide in the middle of all masks, "
        f"which for people who stand or walk is {UPRIGHT[0]} to {UPRIGHT[1]}: were the masks "
        f"{shape}, or does the person not stand upright?",
    )
