"""Masks that are rendered when they are asked for: perhaps never, or not all at a time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.core.types import Array, Indices
from silpose.silhouette import Body, Camera, Degrader, render

Masks = NDArray[np.uint8]


@dataclass(frozen=True, eq=False, repr=False)
class LazyMasks:
    """The masks of a take; index or iterate over them as over an array (F, H, W).

    Attributes
    ----------
    take : str
        Named in errors.
    body : Body
    camera : Camera
    x : ndarray, shape (F, 55)
        Poses, the heading relative to the camera.
    offset : ndarray, shape (F, 3)
        Root relative to the camera's target, metres.
    degrade : callable or None, default=None
        From a mask and its frame to the degraded mask.
    frames : ndarray of int, shape (F,), or None, default=None
        Numbers of these frames in the take; None for all frames.
    held : bool, default=False
        Whether they stay in memory once all of them were asked for.
    """

    take: str
    body: Body
    camera: Camera
    x: Array
    offset: Array
    degrade: Degrader | None = None
    frames: Indices | None = None
    held: bool = False

    def __repr__(self) -> str:
        return f"LazyMasks of '{self.take}', shape {self.shape}"

    def __len__(self) -> int:
        return len(self.x)

    @property
    def shape(self) -> tuple[int, int, int]:
        """(F, H, W)."""
        return len(self), self.camera.height, self.camera.width

    def __getitem__(self, frames: int | np.integer | slice) -> Masks:
        if not isinstance(frames, slice):
            return next(iter(self.part(slice(frames, frames + 1 or None))))
        if self.held and len(range(*frames.indices(len(self)))) == len(self):
            return self._all[frames]
        return np.stack(list(self.part(frames)))

    def __iter__(self) -> Iterator[Masks]:
        return iter(self._all) if self.held else self._rendered()

    def _rendered(self) -> Iterator[Masks]:
        rotations = ANGLES.rotations(self.x)
        masks = render(self.body, self.camera, rotations, self.offset)
        for frame, mask in zip(self._frames, masks, strict=True):
            if not mask.any():
                raise InputError(
                    f"frame {frame} of take '{self.take}' is out of the camera's sight: "
                    "set silhouette.camera.follow=true or a larger silhouette.camera.distance"
                )
            yield mask if self.degrade is None else self.degrade(mask, frame)

    def __array__(self, dtype: object = None, copy: object = None) -> Masks:
        return self._all if self.held else np.stack(list(self))

    def part(self, frames: slice | Indices) -> LazyMasks | Masks:
        """Masks of some frames, not rendered unless they are held already."""
        if "_all" in self.__dict__:
            return self._all[frames]
        part = replace(self, x=self.x[frames], offset=self.offset[frames], held=False)
        return replace(part, frames=self._frames[frames])

    @cached_property
    def _all(self) -> Masks:
        return np.stack(list(self._rendered()))

    @property
    def _frames(self) -> Indices:
        return np.arange(len(self.x)) if self.frames is None else self.frames
