"""Connected components of a mask, put together to people, and the crumbs left over."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import combinations

import cv2
import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Mask

CRUMB = 0.03  # of the largest component's area: smaller ones are never a part of the person
_PIECES = 12  # largest components that are looked at; an uncountable rest is noise
_OWN_HEIGHT, _OWN_AREA = 0.35, 0.1  # of the largest component's: another person has these at least
_OWN_ASPECT = 1.1  # height over width that another person has at least
_ONE_WIDTH = 0.6  # over height: a group of pieces that is wider is more than one person
_NOISY = 5  # crumbs from which a mask counts as noisy
_HOLE = 0.002  # of the person's area: holes that are filled in a noisy mask
_ABOVE_GROUND = 0.2  # of the height: whatever ends so far above the feet does not stand
_PIXEL_GAP = 1.5  # pixels that a gap within one person may have at any resolution
_LIMB_GAP, _HALVES_GAP, _BAND_GAP = 0.05, 0.12, 0.35  # of the height: gaps within one person


@dataclass
class Person:
    """Components that belong to one person.

    Attributes
    ----------
    labels : list of int
        Of the components.
    area : int
        Pixels.
    box : (int, int, int, int)
        Left, top, right and bottom, pixels, the last ones excluded.
    """

    labels: list[int]
    area: int
    box: tuple[int, int, int, int]

    @property
    def height(self) -> int:
        """Height of the bounding box, pixels."""
        return self.box[3] - self.box[1]

    @property
    def width(self) -> int:
        """Width of the bounding box, pixels."""
        return self.box[2] - self.box[0]

    @property
    def middle(self) -> float:
        """Where the middle of the bounding box is from left to right, pixels."""
        return (self.box[0] + self.box[2]) / 2

    def with_piece(self, other: Person) -> Person:
        """Join two persons to one."""
        (l, t, r, b), (ol, ot, o_r, ob) = self.box, other.box  # noqa: E741
        box = min(l, ol), min(t, ot), max(r, o_r), max(b, ob)
        return Person([*self.labels, *other.labels], self.area + other.area, box)


@dataclass(frozen=True)
class Found:
    """People in one mask.

    Attributes
    ----------
    people : list of Person
        The largest first; none in a blank mask.
    components : int
        Number of all components.
    area : int
        Foreground, pixels.
    """

    people: list[Person] = field(default_factory=list)
    components: int = 0
    area: int = 0


def find_people(mask: Mask) -> Found:
    """Find the people in a mask.

    Parameters
    ----------
    mask : ndarray of 0 and 1, shape (H, W)

    Returns
    -------
    found : Found
        A component beside the largest one is another person if it has the size and proportions of
        one; a part of the same person if it is close enough to be a limb, or the other half behind
        a post or a fence; and else belongs to nobody.
    """
    outlines, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not outlines:
        return Found()
    if len(outlines) == 1:  # much the most frequent, and faster to know than components
        left, top, width, height = cv2.boundingRect(outlines[0])
        area = cv2.countNonZero(mask)
        return Found([Person([1], area, (left, top, left + width, top + height))], 1, area)
    part, (left, top) = _foreground(mask)
    count, _, stats, _ = cv2.connectedComponentsWithStats(part, connectivity=8)
    stats[:, [cv2.CC_STAT_LEFT, cv2.CC_STAT_TOP]] += (left, top)
    areas = stats[1:, cv2.CC_STAT_AREA]
    order = 1 + np.argsort(-areas, kind="stable")[:_PIECES]
    pieces = [_piece(int(label), stats[label]) for label in order]
    pieces = [piece for piece in pieces if piece.area >= CRUMB * pieces[0].area]
    return Found(_grouped(pieces), count - 1, int(areas.sum()))


def mask_of(mask: Mask, found: Found, person: Person) -> Mask:
    """Mask of one person alone; that mask itself if there is nothing else in it.

    Parameters
    ----------
    mask : ndarray of 0 and 1, shape (H, W)
    found : Found
        What `find_people` found in it.
    person : Person
        One of these.

    Returns
    -------
    alone : ndarray of 0 and 1, shape (H, W)
        Without holes as small as the crumbs that were left out, where these are many: such a mask
        is noisy inside, too.
    """
    dropped = found.components - len(person.labels)
    if not dropped:
        return mask
    part, (left, top) = _foreground(mask)
    count, labels = cv2.connectedComponents(part, connectivity=8)
    keep = np.zeros(count, np.uint8)
    keep[person.labels] = 1
    alone = np.zeros_like(mask)
    alone[top : top + part.shape[0], left : left + part.shape[1]] = keep[labels]
    return _without_pinholes(alone, _HOLE * person.area) if dropped >= _NOISY else alone


def _foreground(mask: Mask) -> tuple[Mask, tuple[int, int]]:
    """Part of a mask that holds all its foreground, where components are found sooner."""
    left, top, width, height = cv2.boundingRect(mask)
    return mask[top : top + height, left : left + width], (left, top)


def _without_pinholes(mask: Mask, largest: float) -> Mask:
    _, labels, stats, _ = cv2.connectedComponentsWithStats(1 - mask, connectivity=4)
    fill = stats[:, cv2.CC_STAT_AREA] <= largest
    fill[0] = False
    return mask | fill.astype(np.uint8)[labels]


def _piece(label: int, stats: NDArray[np.int32]) -> Person:
    left, top, width, height, area = (int(value) for value in stats)
    return Person([label], area, (left, top, left + width, top + height))


def _grouped(pieces: list[Person]) -> list[Person]:
    """Put pieces together to people, the largest first."""
    groups = list(pieces)
    while (pair := _joinable(groups)) is not None:  # again: a hand is close to a forearm only
        one, other = pair
        groups[one] = groups[one].with_piece(groups.pop(other))
        groups.sort(key=lambda group: -group.area)
    return [groups[0], *(group for group in groups[1:] if _is_person(group, groups[0]))]


def _joinable(groups: list[Person]) -> tuple[int, int] | None:
    """Find two groups of pieces that belong to the same person, the largest first."""
    for one, other in combinations(range(len(groups)), 2):
        if _same(groups[one], groups[other]):
            return one, other
    return None


def _is_person(piece: Person, largest: Person) -> bool:
    return (
        piece.height >= _OWN_HEIGHT * largest.height
        and piece.area >= _OWN_AREA * largest.area
        and piece.height >= _OWN_ASPECT * piece.width
    )


def _same(person: Person, piece: Person) -> bool:
    """Whether a piece belongs to a person."""
    both = person.with_piece(piece)
    across = max(person.box[0], piece.box[0]) - min(person.box[2], piece.box[2])
    along = max(person.box[1], piece.box[1]) - min(person.box[3], piece.box[3])
    near = max(_LIMB_GAP * both.height, _PIXEL_GAP)
    if max(across, along) <= near and not _two_wide(person, piece, both):
        return True
    if along > 0:  # one above the other: a fence, or a belt of the background's colour
        return along <= _BAND_GAP * both.height and -across >= 0.3 * min(person.width, piece.width)
    hanging = piece.box[3] <= person.box[3] - _ABOVE_GROUND * both.height  # an arm, not a child
    side_by_side = across <= _HALVES_GAP * both.height
    half = piece.height >= 0.5 * person.height or (hanging and piece.box[1] >= person.box[1])
    return side_by_side and half and not _two_wide(person, piece, both)


def _two_wide(person: Person, piece: Person, both: Person) -> bool:
    """Whether two upright pieces side by side are wider than one person."""
    tall = piece.height >= 0.5 * person.height and piece.area >= 0.3 * person.area
    return tall and both.width > _ONE_WIDTH * both.height
