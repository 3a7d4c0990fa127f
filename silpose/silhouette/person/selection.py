"""`select_person`: masks of one person alone, from all masks of a source, which is judged too."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from silpose.core.errors import InputError
from silpose.core.parallel import thread_map
from silpose.core.types import Mask
from silpose.silhouette.person.choice import check_person
from silpose.silhouette.person.components import Found, find_people
from silpose.silhouette.person.facts import MaskFacts
from silpose.silhouette.person.selector import PersonSelector, how_to_choose
from silpose.silhouette.person.source_doubts import doubts_about, switching, why_nobody

_RARE = 0.05  # share of frames up to which several people are left to the place of the one before


@dataclass(frozen=True)
class Selection:
    """Masks of one person.

    Attributes
    ----------
    masks : list of ndarray of 0 and 1, each of shape (H, W)
        Without what does not belong to the person; unchanged where there is nothing else, or no
        person.
    facts : MaskFacts
        What is in the masks as they were given.
    doubts : tuple of str
        What may be wrong with them, a sentence each; each was also said as a `UserWarning`.
    """

    masks: list[Mask]
    facts: MaskFacts
    doubts: tuple[str, ...] = ()


def select_person(
    masks: Sequence[Mask],
    person: str | int | None = None,
    names: Sequence[str] | None = None,
    source: str = "",
) -> Selection:
    """Select the person in all masks of a source.

    Parameters
    ----------
    masks : sequence of ndarray of 0 and 1, each of shape (H, W)
        Consecutive frames, blank or not.
    person : str, int or None, default=None
        Which of several people: ``"largest"``, ``"left"`` or ``"right"`` in each frame,
        ``"tracked"`` from the largest in the first frame, or a number from 1, counted from the
        left in the first frame that has so many. None expects one person.
    names : sequence of str, optional
        What the masks are called in messages; by default their indices.
    source : str, default=""
        What the source is called in messages, with quotation marks if it is a path.

    Returns
    -------
    selection : Selection

    Raises
    ------
    InputError
        If several people are in more than a twentieth of the masks and no choice was made, if
        there are fewer people than the number chosen, or if no mask shows a person.

    See Also
    --------
    PersonSelector : Does the same live.
    """
    person = check_person(person)
    if not masks:
        raise InputError("there are no masks: give at least one")
    found = thread_map(lambda frame: find_people(masks[frame]), len(masks))
    called = f" in {source}" if source else ""
    doubts = _check_people(found, person, names, called)
    areas = [own.people[0].area for own in found if own.people]
    start = _start(found, person)
    usual = float(np.median(areas)) if areas else 0.0
    selected: list[tuple[Mask, MaskFacts]] = []
    forward = PersonSelector(person, usual)
    selected = [forward.select(masks[frame], found[frame]) for frame in range(start, len(masks))]
    if start:  # back in time from the frame that shows which person is meant
        backward = PersonSelector(person, usual)
        backward.select(masks[start], found[start])
        before = [backward.select(masks[f], found[f]) for f in reversed(range(start))]
        selected = before[::-1] + selected
    if forward.choice.switches:
        doubts += (switching(str(person), forward.choice.switches, len(masks), called),)
    facts = MaskFacts.concatenate([own for _, own in selected])
    if not facts.seen.any():
        raise InputError(why_nobody(masks, facts, called))
    doubts += doubts_about(masks, facts, called)
    for doubt in doubts:
        warnings.warn(doubt, UserWarning, stacklevel=2)
    return Selection([own for own, _ in selected], facts, doubts)


def _start(found: Sequence[Found], person: str | int | None) -> int:
    """First frame that shows which person is meant."""
    if person is None:
        fits = [len(own.people) == 1 for own in found]
    else:
        least = person if isinstance(person, int) else 1
        fits = [len(own.people) >= least for own in found]
    return int(np.argmax(fits))


def _check_people(
    found: Sequence[Found], person: str | int | None, names: Sequence[str] | None, called: str
) -> tuple[str, ...]:
    """Refuse several people without a choice, and a choice that cannot be; doubt a few frames."""
    people = np.array([len(own.people) for own in found])
    most, several = int(people.max()), int((people > 1).sum())
    if isinstance(person, int) and most and person > most:
        raise InputError(
            f"silhouette.person is {person}, and there are at most {most} people{called}: choose "
            + how_to_choose(most)
        )
    if person is not None or not several:
        return ()
    first = int(np.argmax(people > 1))
    name = f"'{names[first]}'" if names else f"mask {first}"
    seen = int((people > 0).sum())
    if several > _RARE * seen:
        raise InputError(
            f"there are {people[first]} people in {name}{called}, and several in {several} of "
            f"{len(found)} masks: choose {how_to_choose(most)}"
        )
    return (
        f"several people are in {several} of {len(found)} masks{called}, {name} the first: the one "
        f"at the same place as before is taken; to choose, give {how_to_choose(most)}",
    )
