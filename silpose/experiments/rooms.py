"""The rooms of the house, furnished as the settings say: what an experiment is given."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from silpose.dataset import Dataset, Studio
from silpose.descriptor import ShapeContextHistogram
from silpose.experiments.shelf import Shelf
from silpose.regression import Candidates
from silpose.silhouette import Camera


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
    studio : Studio or None
        Where motion is photographed; None where a file is read.
    camera : Camera
    own_masks : OwnMasks
    descriptor : ShapeContextHistogram
        Not fitted yet.
    candidates : Candidates
        The regressors' settings, or what to choose them from.
    seed : int
    """

    dataset: Callable[[], Dataset]
    studio: Studio | None
    camera: Camera
    own_masks: OwnMasks
    descriptor: ShapeContextHistogram
    candidates: Candidates
    seed: int
    shelf: Shelf | None = None
