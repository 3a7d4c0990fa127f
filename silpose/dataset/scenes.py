"""Bodies and cameras for a dataset's sequences: any number of them, drawn from ranges."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import ceil
from typing import Any

import numpy as np

from silpose.core.errors import InputError
from silpose.motion import Motion, mirrored
from silpose.silhouette import Body, Camera

_GOLDEN = 222.49223594996212  # degrees: multiples of it divide the circle ever more evenly
_CAMERA = ("elevation", "focal_length", "distance")
RANGES = (*_CAMERA, "shape")


@dataclass(frozen=True)
class Scene:
    """One sequence to be photographed.

    Attributes
    ----------
    motion : Motion
    body : Body
    camera : Camera
    name : str
        Unique among the shots of a dataset; the motion's own name may not be.
    """

    motion: Motion
    body: Body
    camera: Camera
    name: str


@dataclass(frozen=True)
class SceneSampler:
    """Ranges, [lowest, highest], from which every sequence draws its body and its camera.

    Attributes
    ----------
    frames : int or None
        Of training in all, the same number from every performer, from takes that are photographed
        as often as that needs, each time anew. None photographs every take once.
    around : bool
        Whether the first azimuths of the cameras are spread evenly over 360 degrees, and every
        other camera orbits the other way.
    mirror : bool
        Whether every other sequence is seen in a mirror.
    shape : list of 2 floats, or None
        Length of the vector of ten shape coefficients, in standard deviations; its direction may
        be any. None is the one body.
    elevation, focal_length, distance : list of 2 floats, or None
        Of the camera; None is the one camera's.
    seed : int
    """

    frames: int | None = None
    around: bool = False
    mirror: bool = False
    shape: list[float] | None = None
    elevation: list[float] | None = None
    focal_length: list[float] | None = None
    distance: list[float] | None = None
    seed: int = 0

    def __post_init__(self) -> None:
        if self.frames is not None and self.frames < 1:
            raise InputError(f"silhouette.scenes.frames must be 1 or more, not {self.frames}")
        for name in RANGES:
            ends = getattr(self, name)
            if ends is not None and (len(ends) != 2 or not ends[0] <= ends[1]):
                raise InputError(f"silhouette.scenes.{name} is [lowest, highest], not {ends}")

    def plain(self) -> SceneSampler:
        """Keep how cameras are spread, but of one body and one camera."""
        return SceneSampler(around=self.around, seed=self.seed)

    def range_of(self, name: str, body: Body, camera: Camera) -> tuple[float, float]:
        """Give lowest and highest value of one of `RANGES`, also where it is not drawn."""
        if (ends := getattr(self, name)) is not None:
            return ends[0], ends[1]
        own = float(np.linalg.norm(body.shape or 0)) if name == "shape" else getattr(camera, name)
        return own, own

    def shots(
        self, motions: Sequence[Motion], body: Body, camera: Camera, stream: int = 0
    ) -> list[Scene]:
        """Give every motion a body and a camera.

        Parameters
        ----------
        motions : sequence of Motion
        body : Body
        camera : Camera
            What is not drawn is as in these.
        stream : int
            Another one gives other draws.

        Returns
        -------
        shots : list of Scene
        """
        rng = np.random.default_rng([self.seed, stream])
        parts = (
            stretches(motions, self.frames, rng) if self.frames else [(m, m.name) for m in motions]
        )
        first = rng.uniform(0, 360)
        shots = []
        for k, (motion, name) in enumerate(parts):
            changed: dict[str, Any] = {n: self._draw(n, rng) for n in _CAMERA if getattr(self, n)}
            if self.around:
                changed["azimuth"] = (camera.azimuth + first + k * _GOLDEN) % 360
                changed["orbit"] = camera.orbit if k % 2 else -camera.orbit
            own_body = body if self.shape is None else self._draw_body(body, rng)
            motion = mirrored(motion) if self.mirror and k // 2 % 2 else motion
            shots.append(Scene(motion, own_body, replace(camera, **changed), name))
        return shots

    def _draw(self, name: str, rng: np.random.Generator) -> float:
        lowest, highest = getattr(self, name)
        return float(rng.uniform(lowest, highest))

    def _draw_body(self, body: Body, rng: np.random.Generator) -> Body:
        direction = rng.standard_normal(10)
        shape = direction / np.linalg.norm(direction) * self._draw("shape", rng)
        return Body(body.kind, body.level, shape.tolist())


def stretches(
    motions: Sequence[Motion], frames: int, rng: np.random.Generator
) -> Iterator[tuple[Motion, str]]:
    """Cut so many frames out of motions, the same number from every performer.

    Parameters
    ----------
    motions : sequence of Motion
    frames : int
    rng : numpy.random.Generator
        Of where a stretch begins that is shorter than its take.

    Yields
    ------
    stretch : Motion
        Of a performer's takes in proportion to their lengths, as often as `frames` needs.
    name : str
        The take's, and how often it has been used before.
    """
    by_performer: dict[str, list[Motion]] = {}
    for motion in motions:
        by_performer.setdefault(motion.performer, []).append(motion)
    share, rest = divmod(frames, len(by_performer))
    for k, own in enumerate(by_performer.values()):
        wanted = share + (k < rest)
        available = sum(len(motion) for motion in own)
        again = ceil(wanted / available)
        repeated = own * again
        ends = np.cumsum([len(motion) for motion in repeated]) / (again * available) * wanted
        lengths = np.diff(np.rint(ends).astype(int), prepend=0)
        for i, (motion, length) in enumerate(zip(repeated, lengths, strict=True)):
            if length:
                start = int(rng.integers(len(motion) - length + 1))
                yield motion.part(start, start + length), f"{motion.name}#{i // len(own)}"
