"""Which of several people, frame after frame."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from silpose.core.errors import InputError
from silpose.silhouette.person.components import Found, Person

CHOICES = ("largest", "left", "right", "tracked")
"""Which of several people, other than by their number from the left."""

_REACH, _REACH_PER_FRAME = 0.5, 0.25  # of the height: how far a person moves in no frame and each


def check_person(person: str | int | None) -> str | int | None:
    """Refuse what is no choice of a person.

    Parameters
    ----------
    person : str, int or None
        One of `CHOICES`, or a number from 1, also as text; None makes no choice.

    Returns
    -------
    person : str, int or None
        A number as int.

    Raises
    ------
    InputError
        If it is none of these.
    """
    if person is None or person in CHOICES:
        return person
    number = str(person)
    if number.isdecimal() and int(number) >= 1 and not isinstance(person, bool):
        return int(number)
    raise InputError(
        f"silhouette.person (in Python person) must be {', '.join(CHOICES)} or a number from 1, "
        f"counted from the left, not '{person}'"
    )


class PersonChoice:
    """Chooses one of the people in each frame, of consecutive frames.

    Parameters
    ----------
    person : str, int or None, default=None
        As `check_person` allows. None and ``"tracked"`` begin with the largest person and continue
        with the one at the same place; a number begins with that person from the left, in the
        first frame that has so many. ``"largest"``, ``"left"`` and ``"right"`` are chosen in each
        frame by itself.

    Attributes
    ----------
    switches : int
        How often such a choice fell on one person, while another was closer to where the person of
        the frame before was.
    """

    def __init__(self, person: str | int | None = None) -> None:
        self.person = check_person(person)
        self.switches = 0
        self._last: Person | None = None
        self._missed = 0

    def choose(self, found: Found) -> Person | None:
        """Choose in the next frame; None if the person is not there."""
        people = found.people
        if not people:
            self._missed += 1
            return None
        if self.person in ("largest", "left", "right"):
            own = self._in_this_frame(people)
            self.switches += self._last is not None and self._nearest(people)[0] is not own
            return own
        chosen = self._first(people) if self._last is None else self._continued(people)
        if chosen is None:
            self._missed += 1
        return chosen

    def keep(self, person: Person) -> None:
        """Continue with this one in the next frame."""
        self._last, self._missed = person, 0

    def _in_this_frame(self, people: Sequence[Person]) -> Person:
        if self.person == "largest":
            return people[0]
        by_place = sorted(people, key=lambda person: person.middle)
        return by_place[0 if self.person == "left" else -1]

    def _first(self, people: Sequence[Person]) -> Person | None:
        if not isinstance(self.person, int):
            return people[0]
        by_place = sorted(people, key=lambda person: person.middle)
        return by_place[self.person - 1] if len(by_place) >= self.person else None

    def _continued(self, people: Sequence[Person]) -> Person | None:
        """Return the person that the last one has become; without a choice, else the largest."""
        nearest, change = self._nearest(people)
        if change <= _REACH + _REACH_PER_FRAME * (1 + self._missed):
            return nearest
        return people[0] if self.person is None else None

    def _nearest(self, people: Sequence[Person]) -> tuple[Person, float]:
        """Return the person who is most like the last one, and how different."""
        assert self._last is not None
        changes = [_change(self._last, person) for person in people]
        best = int(np.argmin(changes))
        return people[best], changes[best]


def _change(before: Person, after: Person) -> float:
    """How far apart two boxes are and how different in size, relative to the person's height."""
    across = after.middle - before.middle
    along = (after.box[1] + after.box[3] - before.box[1] - before.box[3]) / 2
    size = max(before.height, 1)
    return float(np.hypot(across, along) / size + abs(np.log(max(after.height, 1) / size)))
