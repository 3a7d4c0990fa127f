"""The rooms of the house, furnished as the settings say: what an experiment is given."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from silpose.dataset import Dataset
from silpose.dataset import Sequence as Take
from silpose.descriptor import AlignedMask, HuMoments, ShapeContextHistogram
from silpose.errors import InputError
from silpose.progress import bar
from silpose.regression import Candidates
from silpose.run import Run
from silpose.silhouette import Camera

Array = NDArray[np.float64]
Descriptor = ShapeContextHistogram | HuMoments | AlignedMask


@dataclass(frozen=True)
class OwnMasks:
    """A folder of the user's own masks.

    Attributes
    ----------
    source : str or None
        The folder.
    blank : {"error", "nan"}
        What to do about a mask without a person.
    frames_per_second : float
    """

    source: str | None = None
    blank: str = "error"
    frames_per_second: float = 15.0


@dataclass(frozen=True)
class Rooms:
    """One furnished house.

    Attributes
    ----------
    dataset : callable
        Gives the `Dataset`: photographs motion, or reads a file.
    camera : Camera
    own_masks : OwnMasks
    descriptor : ShapeContextHistogram
        Not fitted yet.
    candidates : Candidates
        The regressors' settings, or what to choose them from.
    seed : int
    """

    dataset: Callable[[], Dataset]
    camera: Camera
    own_masks: OwnMasks
    descriptor: ShapeContextHistogram
    candidates: Candidates
    seed: int


def masks_of(take: Take, run: Run) -> NDArray[np.uint8]:
    """Masks of a take, without which an experiment cannot go on."""
    if take.masks is None:
        raise InputError(f"{run.experiment} wants masks: these data hold descriptors only")
    return take.masks


def learn_descriptor(rooms: Rooms, data: Dataset) -> ShapeContextHistogram | None:
    """Fit the descriptor to the training masks; None where the data hold descriptors already."""
    masks = [take.masks for take in data.train if take.masks is not None]
    return rooms.descriptor.fit([mask for take in masks for mask in take]) if masks else None


def describe(descriptor: Descriptor | None, takes: Sequence[Take]) -> list[tuple[Array, Array]]:
    """Descriptors (F, d) and poses (F, D) of each take, with a progress bar."""
    with bar("descriptors", sum(len(take) for take in takes)) as advance:
        examples = []
        for take in takes:
            z = take.z
            if take.masks is not None and descriptor is not None:
                z = descriptor.transform(take.masks)
            assert z is not None, "a sequence has masks or descriptors"
            examples.append((z, take.x))
            advance(len(take))
    return examples
