"""Masks that are rendered when they are asked for, for more of them than fit into memory."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.core.types import Array, Indices
from silpose.silhouette import Body, Camera, Degrader, render

Masks = NDArray[np.uint8]


@dataclass(frozen=True)
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
    """

    take: str
    body: Body
    camera: Camera
    x: Array
    offset: Array
    degrade: Degrader | None = None
    frames: Indices | None = None

    def __len__(self) -> int:
        return len(self.x)

    def __getitem__(self, frames: int | np.integer | slice) -> Masks:
        if isinstance(frames, slice):
            return np.stack(list(self.part(frames)))
        return next(iter(self.part(slice(frames, frames + 1 or None))))

    def __iter__(self) -> Iterator[Masks]:
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
        return np.stack(list(self))

    def part(self, frames: slice | Indices) -> LazyMasks:
        """Masks of some frames, not rendered yet."""
        return replace(
            self, x=self.x[frames], offset=self.offset[frames], frames=self._frames[frames]
        )

    @property
    def _frames(self) -> Indices:
        return np.arange(len(self.x)) if self.frames is None else self.frames
