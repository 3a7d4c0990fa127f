"""Masks that are taken when they are asked for, so that any number of them fits into memory."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.silhouette import Body, Camera, render

Array = NDArray[np.float64]
Masks = NDArray[np.uint8]


@dataclass(frozen=True)
class LazyMasks:
    """The masks of a sequence, to be indexed and walked through as an array (F, H, W) is.

    Attributes
    ----------
    take : str
        Named in errors.
    body : Body
    camera : Camera
    x : ndarray, shape (F, 55)
        Poses, the heading relative to the camera.
    offset : ndarray, shape (F, 3)
        Of the root from what the camera looks at, metres.
    spoil : callable, optional
        From a mask and its frame to the mask as it is degraded.
    frames : ndarray of int, shape (F,), or None
        Which frames of the take these are; None is all of them.
    """

    take: str
    body: Body
    camera: Camera
    x: Array
    offset: Array
    spoil: Callable[[Masks, int], Masks] | None = None
    frames: NDArray[np.intp] | None = None

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
            yield mask if self.spoil is None else self.spoil(mask, frame)

    def __array__(self, dtype: object = None, copy: object = None) -> Masks:
        return np.stack(list(self))

    def part(self, frames: slice) -> LazyMasks:
        """Give the photographs of some frames, not taken yet."""
        return replace(
            self, x=self.x[frames], offset=self.offset[frames], frames=self._frames[frames]
        )

    @property
    def _frames(self) -> NDArray[np.intp]:
        return np.arange(len(self.x)) if self.frames is None else self.frames

    @property
    def size(self) -> int:
        """Bytes that all masks take."""
        return len(self) * self.camera.height * self.camera.width


def as_poses(angles: ArrayLike, heading: ArrayLike) -> Array:
    """Pose vectors (F, 55) of angles (F, 54), with headings (F,) relative to the camera."""
    angles = np.asarray(angles)
    return ANGLES.from_angles(np.column_stack([np.asarray(heading), angles[:, 1:]]))
