"""From motion to sequences: every pose before a camera."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Protocol

import numpy as np

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.core.progress import bar
from silpose.dataset.cross_camera import CrossCamera
from silpose.dataset.cross_performer import CrossPerformer
from silpose.dataset.lazy_masks import LazyMasks, as_poses
from silpose.dataset.same_performer import Split
from silpose.dataset.scenes import SceneSampler
from silpose.dataset.take import Dataset, Take
from silpose.motion import Motion
from silpose.silhouette import Body, Camera, Degradation

Spoil = Callable[[np.ndarray, int], np.ndarray]

HELD = 2**28
"""Bytes of training masks that are held; where there are more, they are taken when needed."""


class Splitter(Protocol):
    """Assigns takes to training, validation and test, given each take's performer."""

    def split(self, takes: Mapping[str, str], /) -> Split: ...  # noqa: D102


def photograph(
    motion: Motion,
    body: Body,
    camera: Camera,
    advance: Callable[[int], None] = lambda frames: None,
    name: str | None = None,
    hold: bool = True,
    spoil: Callable[[str], Spoil | None] = lambda name: None,
) -> Take:
    """Pose the body through a motion and take its masks.

    Parameters
    ----------
    motion : Motion
    body : Body
    camera : Camera
    advance : callable, optional
        Called with 1 after every mask that is taken.
    name : str, optional
        Of the sequence; the motion's if not given.
    hold : bool
        Whether all masks are taken at once and held.
    spoil : callable, optional
        From the sequence's name to what degrades its masks.

    Returns
    -------
    sequence : Take
        Its poses' headings are relative to the camera.
    """
    seconds = np.arange(len(motion)) / motion.frames_per_second
    offset, heading = camera.place(motion.root_position, motion.angles[:, 0], seconds)
    x = as_poses(motion.angles, heading)
    name = name or motion.name
    photographs = LazyMasks(motion.name, body, camera, x, offset, spoil(name))
    masks: np.ndarray | LazyMasks = photographs
    if hold:
        masks = np.empty((len(motion), camera.height, camera.width), np.uint8)
        for frame, mask in enumerate(photographs):
            masks[frame] = mask
            advance(1)
    return Take(
        name,
        motion.performer,
        motion.frames_per_second,
        x,
        masks,
        offset,
        take=motion.name,
        camera=camera,
    )


def synthesise(
    takes: Sequence[Motion],
    splitter: Splitter,
    body: Body,
    camera: Camera,
    name: str,
    scenes: SceneSampler | None = None,
    degradation: Degradation | None = None,
) -> Dataset:
    """Photograph every take that the split uses.

    Parameters
    ----------
    takes : sequence of Motion
    splitter : Splitter
    body : Body
    camera : Camera
    name : str
        Of the dataset, as results call it.
    scenes : SceneSampler, optional
        From which bodies and cameras of training are drawn; validation and test see the one body
        and the one camera, but where the splitter gives them others.
    degradation : Degradation, optional
        Of the masks.

    Returns
    -------
    dataset : Dataset
    """
    scenes = scenes or SceneSampler()
    if isinstance(splitter, CrossPerformer):
        _refuse_walkers(takes)
    split = splitter.split({take.name: take.performer for take in takes})
    by_name = {take.name: take for take in takes}
    parts = [
        [by_name[take] for take in part] for part in (split.train, split.validation, split.test)
    ]
    _refuse_leaks(parts)
    if split.by_performer and scenes.frames is None:
        scenes = _equal(scenes, parts[0])
    test_scenes = scenes.plain()
    if isinstance(splitter, CrossCamera):
        test_scenes = splitter.test_scenes(scenes, body, camera)
    shots = [
        scenes.shots(parts[0], body, camera),
        scenes.plain().shots(parts[1], body, camera, stream=1),
        test_scenes.shots(parts[2], body, camera, stream=2),
    ]
    frames = [sum(len(shot.motion) for shot in part) for part in shots]
    damage = degradation or Degradation()
    spoils = [damage.degrader(kinds) for kinds in (damage.train, damage.train, damage.test)]
    hold = frames[0] * camera.height * camera.width <= HELD
    with bar("masks", frames[0] * hold + sum(frames[1:])) as advance:
        train, validation, test = (
            [
                photograph(shot.motion, shot.body, shot.camera, advance, shot.name, held, spoil)
                for shot in part
            ]
            for part, held, spoil in zip(shots, (hold, True, True), spoils, strict=True)
        )
    return Dataset(name, ANGLES, train, validation, test, split.by_performer)


def _equal(scenes: SceneSampler, takes: Sequence[Motion]) -> SceneSampler:
    """Ask for as many frames of every performer as the one with the fewest has."""
    frames: dict[str, int] = {}
    for take in takes:
        frames[take.performer] = frames.get(take.performer, 0) + len(take)
    return replace(scenes, frames=min(frames.values()) * len(frames))


def _refuse_walkers(takes: Sequence[Motion]) -> None:
    """Refuse what was fitted to all performers where none may be known."""
    for take in takes:
        if take.synthetic:
            raise InputError(
                f"take '{take.name}' is of the statistical walker, which was fitted to all "
                "performers and is a stranger to none: add motion=bvh motion.root=FOLDER"
            )


def _refuse_leaks(parts: Sequence[Sequence[Motion]]) -> None:
    """Refuse a motion that is in two parts under two names."""
    seen: dict[bytes, tuple[int, str]] = {}
    for k, part in enumerate(parts):
        for take in part:
            angles = take.angles[:, 1:].round(3)  # whatever its heading
            digest = hashlib.sha256(angles.tobytes()).digest()
            other, name = seen.setdefault(digest, (k, take.name))
            if other != k:
                raise InputError(
                    f"takes '{name}' and '{take.name}' are the same motion, and are in two of "
                    "training, validation and test: remove one of the files"
                )
