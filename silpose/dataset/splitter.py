"""Splits of motion into training, validation and test: what all of them have in common."""

from __future__ import annotations

import hashlib
from abc import abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import ClassVar

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.core.stages import timed
from silpose.dataset.scenes import SceneSampler
from silpose.dataset.synthesis import Renderer
from silpose.dataset.take import Dataset, DatasetSource
from silpose.motion import Motion
from silpose.silhouette import Body, Camera


@dataclass(frozen=True)
class Split:
    """Names of the takes of training, validation and test.

    Attributes
    ----------
    train, validation, test : list of str
    """

    train: list[str]
    validation: list[str]
    test: list[str]


class Splitter(DatasetSource):
    """A split of a source's takes, which are then rendered.

    Attributes
    ----------
    by_performer : bool
        Whether performers are kept apart too, and settings are chosen by leaving one performer
        out at a time.
    """

    by_performer: ClassVar[bool] = False

    @abstractmethod
    def split(self, performers: Mapping[str, str]) -> Split:
        """Assign every take to training, validation or test.

        Parameters
        ----------
        performers : mapping of str to str
            Take to performer, in order.

        Returns
        -------
        split : Split
        """

    def check(self, takes: Sequence[Motion]) -> None:
        """Refuse motion that this split cannot be used for; by default none."""

    def test_scenes(self, training: SceneSampler, body: Body, camera: Camera) -> SceneSampler:
        """Scenes of the test.

        Parameters
        ----------
        training : SceneSampler
            Scenes of the training.
        body : Body
        camera : Camera
            Body and camera of what is not drawn.

        Returns
        -------
        scenes : SceneSampler
            By default with the one body and the one camera.
        """
        return training.plain()

    @timed("masks")
    def load(self, renderer: Renderer) -> Dataset:
        """Split and render the motion of a renderer.

        Parameters
        ----------
        renderer : Renderer

        Returns
        -------
        dataset : Dataset

        Raises
        ------
        InputError
            If the motion cannot be split this way, or a motion is in two parts under two names.
        """
        takes = renderer.takes
        self.check(takes)
        split = self.split({take.name: take.performer for take in takes})
        by_name = {take.name: take for take in takes}
        parts = [[by_name[n] for n in part] for part in (split.train, split.validation, split.test)]
        refuse_copies(parts)
        train, validation, test = parts
        body, camera, scenes = renderer.body, renderer.camera, renderer.scenes
        if self.by_performer and scenes.frames is None:
            scenes = scenes.balanced(train)
        rendered = renderer.render(
            scenes.draw(train, body, camera),
            scenes.plain().draw(validation, body, camera, stream=1),
            self.test_scenes(scenes, body, camera).draw(test, body, camera, stream=2),
        )
        return Dataset(self.full_name(renderer), ANGLES, *rendered, self.by_performer)


def matching(names: Sequence[str], globs: Sequence[str]) -> list[str]:
    """Names that match one of some globs, in order."""
    return [name for name in names if any(fnmatchcase(name, glob) for glob in globs)]


def refuse_copies(parts: Sequence[Sequence[Motion]]) -> None:
    """Refuse a motion that is in two parts of a split under two names."""
    known: dict[bytes, tuple[int, str]] = {}
    for k, part in enumerate(parts):
        for take in part:
            angles = take.angles[:, 1:].round(3)  # regardless of the heading
            digest = hashlib.sha256(angles.tobytes()).digest()
            other, name = known.setdefault(digest, (k, take.name))
            if other != k:
                raise InputError(
                    f"takes '{name}' and '{take.name}' are the same motion, and are in two of "
                    "training, validation and test: remove one of the files"
                )
