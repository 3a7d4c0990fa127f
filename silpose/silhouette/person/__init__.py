"""The person in a mask: which component, whether whole, and what else is there."""

from silpose.silhouette.person.appearance import SIZE as THUMBNAIL_SIZE
from silpose.silhouette.person.choice import CHOICES, check_person
from silpose.silhouette.person.facts import SIDES, MaskFacts
from silpose.silhouette.person.selection import Selection, select_person
from silpose.silhouette.person.selector import PersonSelector

__all__ = [
    "CHOICES",
    "SIDES",
    "THUMBNAIL_SIZE",
    "MaskFacts",
    "PersonSelector",
    "Selection",
    "check_person",
    "select_person",
]
