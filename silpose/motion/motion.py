"""Poses over time, as every source of motion gives them."""

from __future__ import annotations

from dataclasses import dataclass, replace

from silpose.core.types import Array


@dataclass(frozen=True)
class Motion:
    """One continuous take of one performer, on the project's skeleton.

    Attributes
    ----------
    name : str
        Unique within its source.
    performer : str
        Takes of one performer share it, so that splits can keep performers apart.
    frames_per_second : float
    angles : ndarray, shape (F, 54)
        Degrees, in the order of `silpose.core.skeleton.ANGLES`. The first is the heading in the
        world: the azimuth of the hip line, 0 when the person faces +Z and positive towards
        the person's own left.
    root_position : ndarray, shape (F, 3)
        Metres, in the world, +Y up; the ground is at height 0.
    synthetic : bool, default=False
        Whether it comes from a model that was fitted to real performers, so that none is unseen.
    """

    name: str
    performer: str
    frames_per_second: float
    angles: Array
    root_position: Array
    synthetic: bool = False

    def __len__(self) -> int:
        return len(self.angles)

    def part(self, start: int, stop: int) -> Motion:
        """Frames from `start` to `stop`, the last one excluded."""
        return replace(
            self, angles=self.angles[start:stop], root_position=self.root_position[start:stop]
        )
