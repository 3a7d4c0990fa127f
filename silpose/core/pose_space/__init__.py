"""Pose spaces: what the columns of a pose vector mean, and how far apart two poses are.

All packages work on plain arrays ``x (F, D)`` and ask a `PoseSpace` for their meaning, so that
none has to know which kind of pose it holds.
"""

from collections.abc import Mapping

from silpose.core.pose_space.angles import AnglePoseSpace
from silpose.core.pose_space.authors_joints import AuthorsPoseSpace
from silpose.core.pose_space.base import PoseSpace, wrap_degrees, wraps

ANGLES = AnglePoseSpace()
AUTHORS_JOINTS = AuthorsPoseSpace()
SPACES: Mapping[str, PoseSpace] = {space.name: space for space in (ANGLES, AUTHORS_JOINTS)}
"""All pose spaces by name, which is what a saved model holds."""

__all__ = [
    "ANGLES",
    "AUTHORS_JOINTS",
    "SPACES",
    "AnglePoseSpace",
    "AuthorsPoseSpace",
    "PoseSpace",
    "wrap_degrees",
    "wraps",
]
