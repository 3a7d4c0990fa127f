"""The rooms of the house, furnished as the settings say: what an experiment is given."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from silpose.dataset import Dataset, SamePerformer, synthesise
from silpose.descriptor import ShapeContextHistogram
from silpose.motion import Motion
from silpose.regression import Candidates
from silpose.silhouette import Body, Camera


class TakeSource(Protocol):
    """Where takes come from: any motion source."""

    def takes(self) -> list[Motion]:
        """Give all takes."""


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
    source : TakeSource
    body : Body
    camera : Camera
    own_masks : OwnMasks
    splitter : SamePerformer
    dataset_name : str
        As results call it.
    descriptor : ShapeContextHistogram
        Not fitted yet.
    candidates : Candidates
        The regressors' settings, or what to choose them from.
    seed : int
    """

    source: TakeSource
    body: Body
    camera: Camera
    own_masks: OwnMasks
    splitter: SamePerformer
    dataset_name: str
    descriptor: ShapeContextHistogram
    candidates: Candidates
    seed: int

    def dataset(self) -> Dataset:
        """Photograph the takes and split them."""
        return synthesise(
            self.source.takes(), self.splitter, self.body, self.camera, self.dataset_name
        )
