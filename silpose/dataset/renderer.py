"""Where motion is photographed: everything a dataset is made of, and any number of datasets."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Protocol

from silpose.dataset.scenes import SceneSampler
from silpose.dataset.synthesis import Splitter, photograph, synthesise
from silpose.dataset.take import Dataset, Take
from silpose.motion import Motion
from silpose.silhouette import Body, Camera, Degradation


class Source(Protocol):
    """Gives takes."""

    def takes(self) -> Sequence[Motion]: ...  # noqa: D102


@dataclass
class Renderer:
    """Motion, its split, and what it is photographed with.

    Attributes
    ----------
    source : Source
    splitter : Splitter
    body : Body
    camera : Camera
    scenes : SceneSampler
        From which training draws its own bodies and cameras.
    name : str
        Of the datasets.
    degradation : Degradation
        Of the masks.
    """

    source: Source
    splitter: Splitter
    body: Body
    camera: Camera
    scenes: SceneSampler
    name: str
    degradation: Degradation = field(default_factory=Degradation)

    @cached_property
    def takes(self) -> Sequence[Motion]:
        """All takes, read once."""
        return self.source.takes()

    def dataset(self, scenes: SceneSampler | None = None) -> Dataset:
        """Photograph the takes, in scenes of this studio or in others."""
        scenes = scenes or self.scenes
        return synthesise(
            self.takes,
            self.splitter,
            self.body,
            self.camera,
            self.name,
            scenes,
            self.degradation,
        )

    def rerender(self, sequences: Sequence[Take], scenes: SceneSampler) -> list[Take]:
        """Photograph the takes of some sequences anew, in other scenes."""
        names = {sequence.take for sequence in sequences}
        motions = [take for take in self.takes if take.name in names]
        shots = scenes.shots(motions, self.body, self.camera, stream=3)
        return [photograph(s.motion, s.body, s.camera, name=s.name) for s in shots]
