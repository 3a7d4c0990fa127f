"""`Labels`: which numbers of a label image are the person."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Mask
from silpose.silhouette.masks.levels import Levels
from silpose.silhouette.masks.picture import Pixels
from silpose.silhouette.masks.thresholds import surrounds

_THIN = 0.35  # greatest share of flat pixels of a line
_CLASSES = 200  # numbers of classes and instances are smaller where 255 means "not known"
_IGNORED = {255: _CLASSES, -1: 65000, 65535: 65000, 10000: 9999}  # the last of MOTS
_LISTED = 8
_LOOKED_AT = 20  # pictures
_WHOLE = 0.95  # share of all parts that touch each other
_AROUND = 0.6  # least share of the border that is background, around parts of one body
_CERTAIN = 8  # labels, of which areas need not be flat
_LARGE = 0.005  # of all that is no background: labels of that share are looked at
_FLAT = 0.4  # of the area of a label, where a photo's shades are less


@dataclass(frozen=True)
class Labels:
    """The person is what has one of some numbers.

    Attributes
    ----------
    person : tuple of float
        Its labels.
    unknown : float or None, default=None
        Label of pixels that are not known to be anything; each goes to what is nearest.
    """

    person: tuple[float, ...]
    unknown: float | None = None

    def apply(self, plane: Pixels) -> Mask:
        """Separate the person from everything else."""
        if len(self.person) == 1:
            person = (plane == self.person[0]).view(np.uint8)
        else:
            person = np.isin(plane, self.person).view(np.uint8)
        if self.unknown is None:
            return person
        unknown = plane == self.unknown
        return _nearest(person, unknown) if unknown.any() and person.any() else person


def is_label_image(levels: Levels) -> bool:
    """Whether values are few, or fill flat areas as no shades of a photo do."""
    count = levels.count.copy()
    count[int(np.argmax(count))] = 0
    large = count > _LARGE * count.sum()
    flat = levels.flat[large] / count[large]
    few = (count > 0).sum() <= _CERTAIN
    return bool(levels.exact and (few or np.median(flat) >= _FLAT))


def choose_labels(
    levels: Levels,
    values: Sequence[float],
    planes: Sequence[Pixels],
    wanted: int | str | Sequence[int] | None,
    source: str,
) -> tuple[Labels, str]:
    """Decide which labels are the person.

    Parameters
    ----------
    levels : Levels
    values : sequence of float
        The labels, of background and all.
    planes : sequence of ndarray, each of shape (H, W)
    wanted : int, str, sequence of int or None
        As `MaskSource.label`.
    source : str
        What the source is called in messages.

    Returns
    -------
    labels : Labels
    words : str
        What was decided.

    Raises
    ------
    InputError
        If there are several people, or the wanted label does not occur.
    """
    if wanted is not None and not levels.exact:  # more values than are told apart
        return Labels(_numbers(wanted)), _words(wanted, None)
    background = _background(levels, values)
    unknown = _unknown(levels, values, background)
    people = [value for value in values if value not in (background, unknown)]
    if wanted is not None:
        return Labels(_wanted(wanted, people, levels, source), unknown), _words(wanted, unknown)
    if unknown is not None:
        _check_not_mixed(planes, people, unknown, source)
    if len(people) == 1:
        return Labels((people[0],), unknown), _words(int(people[0]), unknown)
    if background == 0 and people == [1, 2, 3] and _as_grabcut(planes):
        return Labels((1.0, 3.0)), "labels 1 and 3, around which 2 lies, as GrabCut writes them"
    around = levels.border[np.searchsorted(levels.values, background)]
    if around >= _AROUND * levels.border.sum() and _are_parts(planes, people):
        words = f"labels {_range(people)}, together as parts of one body" + _void(unknown)
        return Labels(tuple(people), unknown), words
    raise InputError(
        f"{source} has {len(people)} labels, {_listing(levels, people)}: choose the person by "
        f"silhouette.label={people[0]:.15g} (in Python label={people[0]:.15g}), or all as parts of "
        "one body by silhouette.label=all"
    )


def _words(wanted: object, unknown: float | None) -> str:
    return f"label {wanted}" + _void(unknown)


def _void(unknown: float | None) -> str:
    return "" if unknown is None else f", {unknown:.15g} (not known) given to what is nearest"


def _range(values: Sequence[float]) -> str:
    return f"{min(values):.15g} to {max(values):.15g}"


def _background(levels: Levels, values: Sequence[float]) -> float:
    """Take the label of most of the border for the background."""
    positions = np.searchsorted(levels.values, values)
    border = levels.border[positions]
    return float(values[int(np.argmax(border))]) if border.sum() else min(values)


def _unknown(levels: Levels, values: Sequence[float], background: float) -> float | None:
    """Find the label that means "not known"."""
    for label, largest in _IGNORED.items():
        others = [value for value in values if value not in (label, background)]
        if label not in values or not others or label == background or max(others) > largest:
            continue
        at = int(np.searchsorted(levels.values, label))
        if label != 255 or max(others) <= 60 or levels.flat[at] < _THIN * levels.count[at]:
            return float(label)
    return None


def _wanted(
    wanted: int | str | Sequence[int], people: Sequence[float], levels: Levels, source: str
) -> tuple[float, ...]:
    if wanted == "all":
        return tuple(people)
    chosen = _numbers(wanted)
    missing = [label for label in chosen if label not in people]
    if missing:
        raise InputError(
            f"{source} has no label {missing[0]:.15g}, but {_listing(levels, people)}: choose the "
            f"person by silhouette.label={people[0]:.15g} (in Python label={people[0]:.15g})"
        )
    return chosen


def _numbers(wanted: int | str | Sequence[int]) -> tuple[float, ...]:
    try:
        items = wanted.split(",") if isinstance(wanted, str) else np.ravel(np.asarray(wanted))
        return tuple(float(int(item)) for item in items)
    except (TypeError, ValueError):
        raise InputError(
            f"silhouette.label must be a number, several, or all, not '{wanted}'"
        ) from None


def _check_not_mixed(
    planes: Sequence[Pixels], people: Sequence[float], unknown: float, source: str
) -> None:
    """Refuse pictures of which some show people by what means "not known" in others."""
    for plane in planes:
        if (plane == unknown).mean() > 0.01 and not np.isin(plane, people).any():
            raise InputError(
                f"{source} mixes pictures of the values 0 and {people[0]:.15g} with others of 0 "
                f"and {unknown:.15g}: say what is the person by silhouette.threshold=0.5 "
                "(in Python threshold=0.5)"
            )


def _listing(levels: Levels, people: Sequence[float]) -> str:
    total = levels.count.sum()
    areas = levels.count[np.searchsorted(levels.values, people)] / total
    order = np.argsort(-areas, kind="stable")[:_LISTED]
    listed = [f"{people[k]:.15g} ({100 * areas[k]:.2g} % of the pixels)" for k in sorted(order)]
    more = len(people) - len(listed)
    return ", ".join(listed) + (f" and {more} smaller" if more else "")


def _as_grabcut(planes: Sequence[Pixels]) -> bool:
    """Whether 2, OpenCV's probable background, lies between the background and 1 and 3."""
    order = np.array([0, 2, 1, 2], np.uint8)
    return surrounds([order[plane.astype(np.intp)] for plane in planes], np.array([0, 1, 2]))


def _are_parts(planes: Sequence[Pixels], people: Sequence[float]) -> bool:
    """Whether labels are parts of one body: three or more, all joined, and upright."""
    if len(people) < 3:
        return False
    joined, several, upright = [], [], []
    for k in np.unique(np.linspace(0, len(planes) - 1, _LOOKED_AT).astype(int)):
        union = np.isin(planes[k], people).astype(np.uint8)
        if not union.any():
            continue
        *_, boxes, _ = cv2.connectedComponentsWithStats(union)
        largest = boxes[1 + int(np.argmax(boxes[1:, cv2.CC_STAT_AREA]))]
        joined.append(largest[cv2.CC_STAT_AREA] >= _WHOLE * union.sum())
        several.append(len(np.unique(planes[k][union > 0])) >= 3)
        upright.append(largest[cv2.CC_STAT_HEIGHT] > largest[cv2.CC_STAT_WIDTH])
    return bool(joined) and all(np.mean(found) > 0.5 for found in (joined, several, upright))


def _nearest(person: Mask, unknown: np.ndarray) -> Mask:
    """Give each unknown pixel to the person or the background, whichever is nearer."""
    to_person = cv2.distanceTransform(1 - person, cv2.DIST_L2, 5)
    background = ((person == 0) & ~unknown).view(np.uint8)
    to_background = cv2.distanceTransform(1 - background, cv2.DIST_L2, 5)
    return np.where(unknown, to_person < to_background, person > 0).view(np.uint8)
