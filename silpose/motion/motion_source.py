"""The interface of all sources of motion."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from typing import ClassVar

from silpose.motion.motion import Motion


class MotionSource(ABC):
    """A source of motion.

    Attributes
    ----------
    name : str
        Part of the names of datasets.
    """

    name: ClassVar[str]

    def takes(self) -> Sequence[Motion]:
        """All motion of the source, read at the first call."""
        return self._takes

    @cached_property
    def _takes(self) -> list[Motion]:
        return self.read()

    @abstractmethod
    def read(self) -> list[Motion]:
        """Read or synthesise all motion anew."""

    def files(self) -> list[Path]:
        """Files that are read; none for synthetic motion."""
        return []
