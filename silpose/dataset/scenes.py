"""Scenes of a dataset: for every take a body and a camera, drawn from ranges."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import ceil
from typing import Any

import numpy as np

from silpose.core.errors import InputError
from silpose.dataset.views import seen_from
from silpose.motion import Motion, mirrored
from silpose.silhouette import Body, Camera

_GOLDEN = 222.49223594996212  # degrees; its multiples divide the circle ever more evenly
_CAMERA = ("elevation", "focal_length", "distance")
RANGES = (*_CAMERA, "shape")


@dataclass(frozen=True)
class Scene:
    """One take that is to be rendered.

    Attributes
    ----------
    motion : Motion
    body : Body
    camera : Camera
    name : str
        Unique in a dataset, other than the motion's name.
    """

    motion: Motion
    body: Body
    camera: Camera
    name: str


@dataclass(frozen=True)
class SceneSampler:
    """Ranges, [lowest, highest], from which every take draws its body and its camera.

    Attributes
    ----------
    frames : int or None, default=None
        Number of frames in all, the same from every performer; takes are rendered repeatedly, in
        scenes of their own, until it is reached. None renders every take once.
    around : bool, default=False
        Whether the cameras' first azimuths are spread evenly over 360 degrees, and every other
        camera orbits the other way.
    mirror : bool, default=False
        Whether every other pair of takes is mirrored, left and right.
    shape : [float, float] or None, default=None
        Length of the vector of ten shape coefficients, in standard deviations; its direction is
        drawn evenly. None is the one body.
    elevation : [float, float] or None, default=None
        Elevation of the camera, degrees; None is the one camera's, as for the other ranges.
    focal_length : [float, float] or None, default=None
        Focal length of the camera, image heights.
    distance : [float, float] or None, default=None
        Distance of the camera, metres.
    views : list of float or None, default=None
        Directions of straight walks relative to the camera, degrees: 0 comes towards it, positive
        ones turn to the right in the image. Every take is divided among them, also those of
        validation and test. None leaves headings as they are.
    view_change : float, default=0.0
        Degrees by which the direction changes in each view, as that of a passing person does.
    seed : int, default=0
        Seed of all draws.

    Raises
    ------
    InputError
        If a range is not one, or `frames` is not positive.
    """

    frames: int | None = None
    around: bool = False
    mirror: bool = False
    shape: list[float] | None = None
    elevation: list[float] | None = None
    focal_length: list[float] | None = None
    distance: list[float] | None = None
    views: list[float] | None = None
    view_change: float = 0.0
    seed: int = 0

    def __post_init__(self) -> None:
        if self.frames is not None and self.frames < 1:
            raise InputError(f"silhouette.scenes.frames must be at least 1, not {self.frames}")
        for name in RANGES:
            ends = getattr(self, name)
            if ends is not None and (len(ends) != 2 or not ends[0] <= ends[1]):
                raise InputError(f"silhouette.scenes.{name} must be [lowest, highest], not {ends}")
        if self.views is not None and (self.around or not self.views):
            raise InputError(
                "silhouette.scenes.views needs at least one view and scenes.around=false"
            )

    def plain(self) -> SceneSampler:
        """Sampler with the one body and the one camera, spread around or in views as here."""
        return SceneSampler(
            around=self.around, views=self.views, view_change=self.view_change, seed=self.seed
        )

    def balanced(self, motions: Sequence[Motion]) -> SceneSampler:
        """Sampler of as many frames of every performer as the one with the fewest has."""
        frames: dict[str, int] = {}
        for motion in motions:
            frames[motion.performer] = frames.get(motion.performer, 0) + len(motion)
        return replace(self, frames=min(frames.values()) * len(frames))

    def range_of(self, name: str, body: Body, camera: Camera) -> tuple[float, float]:
        """Lowest and highest value of one of `RANGES`, also where it is not drawn."""
        if (ends := getattr(self, name)) is not None:
            return ends[0], ends[1]
        own = float(np.linalg.norm(body.shape or 0)) if name == "shape" else getattr(camera, name)
        return own, own

    def draw(
        self, motions: Sequence[Motion], body: Body, camera: Camera, stream: int = 0
    ) -> list[Scene]:
        """Draw a body and a camera for every motion.

        Parameters
        ----------
        motions : sequence of Motion
        body : Body
        camera : Camera
            Body and camera where none are drawn.
        stream : int, default=0
            Selects another stream of random numbers.

        Returns
        -------
        scenes : list of Scene
        """
        rng = np.random.default_rng([self.seed, stream])
        parts = (
            stretches(motions, self.frames, rng) if self.frames else [(m, m.name) for m in motions]
        )
        if self.views is not None:
            camera = replace(camera, azimuth=0.0, orbit=0.0)
            parts = self._in_views(list(parts), self.views)
        first = rng.uniform(0, 360)
        scenes = []
        for k, (motion, name) in enumerate(parts):
            changed: dict[str, Any] = {n: self._draw(n, rng) for n in _CAMERA if getattr(self, n)}
            if self.around:
                changed["azimuth"] = (camera.azimuth + first + k * _GOLDEN) % 360
                changed["orbit"] = camera.orbit if k % 2 else -camera.orbit
            own_body = body if self.shape is None else self._draw_body(body, rng)
            motion = mirrored(motion) if self.mirror and k // 2 % 2 else motion
            scenes.append(Scene(motion, own_body, replace(camera, **changed), name))
        return scenes

    def _in_views(
        self, parts: Sequence[tuple[Motion, str]], views: Sequence[float]
    ) -> list[tuple[Motion, str]]:
        """Divide motions among the views, each beginning with another one."""
        return [
            (replace(part, name=motion.name), name + part.name.removeprefix(motion.name))
            for k, (motion, name) in enumerate(parts)
            for part in seen_from(motion, views, self.view_change, k)
        ]

    def _draw(self, name: str, rng: np.random.Generator) -> float:
        lowest, highest = getattr(self, name)
        return float(rng.uniform(lowest, highest))

    def _draw_body(self, body: Body, rng: np.random.Generator) -> Body:
        direction = rng.standard_normal(10)
        shape = direction / np.linalg.norm(direction) * self._draw("shape", rng)
        return Body(body.kind, body.level, shape=shape.tolist())


def stretches(
    motions: Sequence[Motion], frames: int, rng: np.random.Generator
) -> Iterator[tuple[Motion, str]]:
    """Cut a number of frames out of motions, the same from every performer.

    Parameters
    ----------
    motions : sequence of Motion
    frames : int
    rng : numpy.random.Generator
        Draws where a stretch begins that is shorter than its motion.

    Yields
    ------
    stretch : Motion
        A performer's motions in proportion to their lengths, repeated until the share of `frames`
        is reached.
    name : str
        The motion's name, and the number of its stretches before this one.
    """
    by_performer: dict[str, list[Motion]] = {}
    for motion in motions:
        by_performer.setdefault(motion.performer, []).append(motion)
    share, rest = divmod(frames, len(by_performer))
    for k, own in enumerate(by_performer.values()):
        wanted = share + (k < rest)
        available = sum(len(motion) for motion in own)
        rounds = ceil(wanted / available)
        repeated = own * rounds
        ends = np.cumsum([len(motion) for motion in repeated]) / (rounds * available) * wanted
        lengths = np.diff(np.rint(ends).astype(int), prepend=0)
        for i, (motion, length) in enumerate(zip(repeated, lengths, strict=True)):
            if length:
                start = int(rng.integers(len(motion) - length + 1))
                yield motion.part(start, start + length), f"{motion.name}#{i // len(own)}"
