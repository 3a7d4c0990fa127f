"""`PersonSelector`: masks of one person alone, and what else is in each, one frame at a time."""

from __future__ import annotations

import warnings
from collections import deque

import cv2
import numpy as np

from silpose.core.errors import InputError
from silpose.core.frame_border import cuts
from silpose.core.types import Mask
from silpose.silhouette.person.appearance import SIZE, thumbnail
from silpose.silhouette.person.choice import PersonChoice
from silpose.silhouette.person.components import Found, Person, find_people, mask_of
from silpose.silhouette.person.facts import MaskFacts

FILLED = 0.85
"""Share of the frame from which a mask is no person: a crop to the bounding box has 0.75."""
FRAGMENT = 0.05
"""Share of the person's usual area below which there is only a piece of a person."""
_LOWEST, _LOWEST_SHARE = 6, 0.025

_REMEMBERED = 60  # frames from which the usual area is known in a stream


class PersonSelector:
    """Selects the person in each mask of consecutive frames.

    Parameters
    ----------
    person : str, int or None, default=None
        Which of several people, as `silpose.silhouette.person.check_person` allows.
    usual_area : float or None, default=None
        Pixels that the person usually covers; by default those of the last 60 frames.

    See Also
    --------
    select_person : Does so for all masks of a source, and judges the source.
    """

    def __init__(self, person: str | int | None = None, usual_area: float | None = None) -> None:
        self.choice = PersonChoice(person)
        self._usual = usual_area
        self._areas: deque[int] = deque(maxlen=_REMEMBERED)
        self._begun = self._doubted = False

    def step(self, mask: Mask) -> tuple[Mask, MaskFacts]:
        """Select the person in the next mask.

        Parameters
        ----------
        mask : ndarray of 0 and 1, shape (H, W)

        Returns
        -------
        person : ndarray of 0 and 1, shape (H, W)
            Without what does not belong to the person; the whole mask where there is none.
        facts : MaskFacts
            Of this one mask.

        Raises
        ------
        InputError
            If the first mask with a person shows several, and no choice was made.
        """
        found = find_people(mask)
        people = len(found.people)
        if people > 1 and self.choice.person is None:
            self._say_several(people)
        self._begun = self._begun or people > 0
        selected = self.select(mask, found)
        if self.choice.switches and not self._doubted:
            self._doubted = True
            warnings.warn(
                f"the person chosen by silhouette.person={self.choice.person} is another one than "
                "in the mask before: to follow one person, give silhouette.person=tracked (in "
                "Python person='tracked')",
                stacklevel=2,
            )
        return selected

    def select(self, mask: Mask, found: Found) -> tuple[Mask, MaskFacts]:
        """Select as `step` does, among people who have been found already."""
        filled = found.area >= FILLED * mask.size
        person = None if filled else self.choice.choose(found)
        fragment = found.area > 0 and not filled
        if person is not None and not self._is_fragment(person, mask.shape[0]):
            fragment = False
            self.choice.keep(person)
            self._areas.append(person.area)
            mask = mask_of(mask, found, person)
            return mask, _facts(found, person, mask)
        return mask, _facts(found, None, mask, fragment=fragment, filled=filled)

    def _say_several(self, people: int) -> None:
        """Refuse several people in the first mask, and doubt them once where they come later."""
        if not self._begun:
            raise InputError(
                f"there are {people} people in the first mask: choose {how_to_choose(people)}"
            )
        if not self._doubted:
            self._doubted = True
            warnings.warn(
                f"{people} people are in a mask: the one at the same place as before is taken; to "
                f"choose, give {how_to_choose(people)}",
                stacklevel=3,
            )

    def _is_fragment(self, person: Person, frame_height: int) -> bool:
        usual = self._usual
        if usual is None:
            usual = float(np.median(self._areas)) if self._areas else 0.0
        return person.height < lowest_person(frame_height) or person.area < FRAGMENT * usual


def lowest_person(frame_height: int) -> float:
    """Height below which nothing is a person, pixels: 6, or a share of a high frame."""
    return max(_LOWEST, _LOWEST_SHARE * frame_height)


def how_to_choose(people: int) -> str:
    """Complete a sentence that asks which person is meant."""
    numbers = f"a number from 1 to {people}, counted from the left"
    return (
        f"silhouette.person=largest, left, right, tracked or {numbers} (in Python "
        "person='largest' and so on)"
    )


def _facts(
    found: Found, person: Person | None, mask: Mask, *, fragment: bool = False, filled: bool = False
) -> MaskFacts:
    parts = len(person.labels) if person else 0
    small = np.zeros((SIZE, SIZE), np.uint8)
    cut, aspect, dropped_area = np.zeros(4), np.nan, 0.0
    if person is not None:
        left, top, *_ = person.box
        small = thumbnail(mask, (left, top, person.width, person.height))
        cut, aspect = cuts(mask), person.height / person.width
        dropped_area = max(0.0, 1 - cv2.countNonZero(mask) / found.area)
    return MaskFacts(
        people=np.array([len(found.people)]),
        dropped=np.array([found.components - parts if person else 0]),
        dropped_area=np.array([dropped_area]),
        cuts=cut[None],
        blank=np.array([found.area == 0]),
        fragment=np.array([fragment]),
        filled=np.array([filled]),
        height=np.array([float(person.height if person else 0)]),
        aspect=np.array([aspect]),
        thumbnails=small[None],
    )
