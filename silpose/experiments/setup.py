"""The rooms of the house, furnished as the settings say: what an experiment is given."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.dataset import Dataset, Renderer, Take
from silpose.descriptor import ShapeContextHistogram
from silpose.model.descriptor_cache import DescriptorCache
from silpose.recording.runs.run_folder import Run
from silpose.regression import Candidates
from silpose.silhouette import Camera
from silpose.tracking import TrackingSettings


@dataclass(frozen=True)
class OwnMasks:
    """The user's own masks.

    Attributes
    ----------
    source : str or None
        A folder or a video.
    blank : {"error", "nan"}
        What to do about a mask without a person.
    frames_per_second : float
    """

    source: str | None = None
    blank: str = "error"
    frames_per_second: float = 15.0


@dataclass(frozen=True)
class Components:
    """One furnished house.

    Attributes
    ----------
    dataset : callable
        Gives the `Dataset`: photographs motion, or reads a file.
    studio : Renderer or None
        Where motion is photographed; None where a file is read.
    camera : Camera
    own_masks : OwnMasks
    descriptor : ShapeContextHistogram
        Not fitted yet.
    candidates : Candidates
        The regressors' settings, or what to choose them from.
    tracking : TrackingSettings
        Likewise of trackers and their rivals.
    seed : int
    """

    dataset: Callable[[], Dataset]
    studio: Renderer | None
    camera: Camera
    own_masks: OwnMasks
    descriptor: ShapeContextHistogram
    candidates: Candidates
    tracking: TrackingSettings
    seed: int
    shelf: DescriptorCache | None = None


def masks_of(take: Take, run: Run) -> NDArray[np.uint8]:
    """Masks of a take, without which an experiment cannot go on."""
    want_masks([take], run)
    return np.asarray(take.masks)


def want_masks(takes: Sequence[Take], run: Run) -> None:
    """Refuse data without masks before time is spent on them."""
    if any(take.masks is None for take in takes):
        raise InputError(f"{run.experiment} wants masks: these data hold descriptors only")


def studio_of(rooms: Components, run: Run) -> Renderer:
    """Where motion is photographed, for experiments that vary how."""
    if rooms.studio is None:
        raise InputError(f"{run.experiment} photographs motion: it cannot vary what a file holds")
    return rooms.studio
