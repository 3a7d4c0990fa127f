"""`FollowedPerson`: one person from frame to frame, found again after having been lost."""

from __future__ import annotations

import warnings
from dataclasses import replace

import numpy as np

from silpose.core.types import Mask
from silpose.silhouette.person import MaskFacts, PersonSelector, check_person

_LOST = 0.5  # seconds after which a person who is not where expected is looked for anew
_SEVERAL = 5  # frames with several people, from which they are no flicker


class FollowedPerson:
    """Selects one person in the masks of a video.

    Parameters
    ----------
    person : str, int or None
        As of `silpose.silhouette.person.PersonSelector`; None follows the largest of the first
        frame, and says so where there are several.
    """

    def __init__(self, person: str | int | None) -> None:
        self.person = check_person(person)
        self._selector = self._new()
        self._lost_since: float | None = None
        self._several = 0

    def step(self, mask: Mask, time: float) -> tuple[Mask, MaskFacts]:
        """Select the person in the next mask.

        Parameters
        ----------
        mask : ndarray of 0 and 1, shape (H, W)
        time : float
            Seconds.

        Returns
        -------
        person : ndarray of 0 and 1, shape (H, W)
            Blank if the person is not seen, even if others are.
        facts : MaskFacts
            Of the mask as it was given; ``fragment`` if there are others only.
        """
        alone, facts = self._selector.step(mask)
        self._count(facts)
        seen = bool(facts.seen[0]) and bool(facts.height[0])
        elsewhere = not seen and bool(facts.people[0]) and not facts.filled[0]
        if seen or not facts.people[0]:
            self._lost_since = None
        elif self._lost_since is None:
            self._lost_since = time
        if elsewhere and self._lost_since is not None and time - self._lost_since >= _LOST:
            self._selector, self._lost_since = self._new(), None
            alone, facts = self._selector.step(mask)
            seen = bool(facts.seen[0]) and bool(facts.height[0])
        if seen:
            return alone, facts
        if facts.seen[0]:
            facts = replace(facts, fragment=np.array([True]))
        return np.zeros_like(mask), facts

    def _new(self) -> PersonSelector:
        return PersonSelector("tracked" if self.person is None else self.person)

    def _count(self, facts: MaskFacts) -> None:
        if self.person is not None or facts.people[0] < 2:
            return
        self._several += 1
        if self._several == _SEVERAL:
            warnings.warn(
                f"there are {facts.people[0]} people in the video, and the largest of the first "
                "frame is followed: to choose, give silhouette.person=largest, left, right, "
                "tracked or a number, counted from the left (in Python person='largest' and so on)",
                stacklevel=4,
            )
