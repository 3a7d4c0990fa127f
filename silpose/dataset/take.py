"""Takes, datasets of them, and the interface of whatever makes a dataset."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, ClassVar

import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array, Indices, Mask
from silpose.dataset.lazy_masks import LazyMasks
from silpose.silhouette import Camera

if TYPE_CHECKING:
    from silpose.dataset.synthesis import Renderer


@dataclass(frozen=True)
class Take:
    """One continuous take: true poses, and masks or descriptors of them.

    Attributes
    ----------
    name, performer : str
    frames_per_second : float
    x : ndarray, shape (F, D)
        True poses.
    masks : ndarray of 0 and 1, shape (F, H, W), or LazyMasks, or None
        None where the data hold descriptors instead.
    offset : ndarray, shape (F, 3)
        Root relative to the camera's target, metres.
    z : ndarray, shape (F, d), or None, default=None
        Descriptors, where the data hold these instead of masks.
    source : str or None, default=None
        Name of the motion that was rendered, of which there may be several takes.
    camera : Camera or None, default=None
        The camera in front of which the masks were rendered.
    """

    name: str
    performer: str
    frames_per_second: float
    x: Array
    masks: NDArray[np.uint8] | LazyMasks | None
    offset: Array
    z: Array | None = None
    source: str | None = None
    camera: Camera | None = None

    def __len__(self) -> int:
        return len(self.x)

    @property
    def title(self) -> str:
        """The take in words, such as ``take 'spiral' of walker_3``."""
        return f"take '{self.name}' of {self.performer}"

    @property
    def has_masks(self) -> bool:
        """Whether there are masks, rather than descriptors only."""
        return self.masks is not None

    def mask_array(self) -> NDArray[np.uint8]:
        """All masks in memory, shape (F, H, W).

        Raises
        ------
        InputError
            If there are none.
        """
        if self.masks is None:
            raise InputError(
                f"take '{self.name}' holds descriptors but no masks: choose a dataset that is "
                "rendered, such as dataset=same_performer"
            )
        return np.asarray(self.masks)

    def masks_at(self, frames: Indices) -> Sequence[Mask]:
        """Masks (H, W) of some frames, in their order; only these are rendered."""
        if self.masks is None:
            return []
        if isinstance(self.masks, LazyMasks):
            return list(self.masks.part(frames))
        return [self.masks[frame] for frame in frames.tolist()]

    def camera_or(self, default: Camera) -> Camera:
        """Camera of this take, or the default where it has none of its own."""
        return default if self.camera is None else self.camera


@dataclass(frozen=True)
class Dataset:
    """Takes of training, validation and test.

    Attributes
    ----------
    name : str
    space : PoseSpace
        Meaning of the poses.
    train, validation, test : sequence of Take
    by_performer : bool, default=False
        Whether performers are kept apart too, and settings are chosen by leaving one performer
        out at a time.

    Raises
    ------
    InputError
        If two takes have the same name, or a motion (with `by_performer` a performer) is in two
        of the lists.
    """

    name: str
    space: PoseSpace
    train: Sequence[Take]
    validation: Sequence[Take]
    test: Sequence[Take]
    by_performer: bool = False

    def __post_init__(self) -> None:
        self._refuse_overlap("take", lambda take: take.source or take.name)
        if self.by_performer:
            self._refuse_overlap("performer", lambda take: take.performer)
        names = [take.name for part in self._parts for take in part]
        if len(set(names)) < len(names):
            twice = next(name for name in names if names.count(name) > 1)
            raise InputError(f"two takes are called '{twice}': rename one of the files")

    @property
    def has_masks(self) -> bool:
        """Whether all takes have masks, rather than descriptors only."""
        return all(take.has_masks for part in self._parts for take in part)

    @property
    def _parts(self) -> tuple[Sequence[Take], ...]:
        return self.train, self.validation, self.test

    def _refuse_overlap(self, what: str, key: Callable[[Take], str]) -> None:
        parts = [{key(take) for take in part} for part in self._parts]
        for one, other in combinations(parts, 2):
            if one & other:
                raise InputError(
                    f"{what} '{min(one & other)}' is in two of training, validation and test"
                )


class DatasetSource(ABC):
    """A choice of dataset.

    Attributes
    ----------
    name : str
    rendered : bool
        Whether masks are rendered, so that bodies, cameras and degradations can be varied.
    """

    name: ClassVar[str]
    rendered: ClassVar[bool] = True

    @abstractmethod
    def load(self, renderer: Renderer) -> Dataset:
        """Render the dataset, or read it from its file.

        Parameters
        ----------
        renderer : Renderer
            Motion and how to render it; ignored by data that are read.
        """

    def full_name(self, renderer: Renderer) -> str:
        """Name of the dataset that `load` makes."""
        return f"{self.name}/{renderer.source.name}" if self.rendered else self.name


def poses(takes: Iterable[Take]) -> Array:
    """All poses of some takes, shape (n, D)."""
    return np.concatenate([take.x for take in takes])
