"""Frames to calibrate with: held-out masks as they are and as odd ones, with their true poses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import ANGLES
from silpose.core.serialisation import State, prefixed, without_prefix
from silpose.core.types import Array, Indices, Mask
from silpose.dataset import Take
from silpose.descriptor import ShapeContextHistogram
from silpose.model.confidence.odd_masks import NOBODY, ODD, odd_mask, odd_poses
from silpose.silhouette import Body, render
from silpose.silhouette.person import MaskFacts, PersonSelector

RENDERED = ("bent", "build", "view", "bent")
"""Kinds of odd frames that are rendered anew: other poses, other builds, other elevations."""

FREQUENT = ("cut", "merged", "stretched", "cut", "foreign", "foreign", "foreign")
"""Kinds that are drawn more often: what masks of one's own are like, and all that is no person."""

_SCENES = 2  # bodies and cameras of each kind, as building a body takes long
_BUILD = (2.0, 6.0)  # standard deviations
_ELEVATION = (10.0, 45.0)  # degrees above the camera's own


@dataclass(frozen=True, eq=False)
class Frames:
    """Descriptors, true poses and facts of some frames.

    Attributes
    ----------
    z : ndarray, shape (F, d)
    x : ndarray, shape (F, D)
        NaN where a mask shows nobody.
    facts : MaskFacts or None
        None where there are descriptors only.
    odd : ndarray of bool, shape (F,)
        Whether frames are not as in training.
    kinds : list of str
        ``clean``, or what is odd.
    """

    z: Array
    x: Array
    facts: MaskFacts | None
    odd: NDArray[np.bool_]
    kinds: list[str]

    def __getitem__(self, frames: Indices) -> Frames:
        """Take some of the frames."""
        return Frames(
            self.z[frames], self.x[frames], None if self.facts is None else self.facts[frames],
            self.odd[frames], [self.kinds[f] for f in frames.tolist()],
        )  # fmt: skip

    def to_arrays(self) -> State:
        """Return everything as arrays."""
        state: State = {name: getattr(self, name) for name in ("z", "x", "odd")}
        state["kinds"] = np.array(self.kinds)
        return state if self.facts is None else state | prefixed("facts", self.facts.to_arrays())

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore from the result of `to_arrays`."""
        facts = without_prefix("facts", state)
        return cls(
            state["z"], state["x"], MaskFacts(**facts) if facts else None, state["odd"],
            state["kinds"].tolist(),
        )  # fmt: skip


def frames_of_masks(
    takes: Sequence[Take],
    descriptor: ShapeContextHistogram,
    clean: int,
    odd: int,
    rng: np.random.Generator,
) -> Frames:
    """Draw frames of takes with masks, and make odd ones of some.

    Parameters
    ----------
    takes : sequence of Take
    descriptor : ShapeContextHistogram
        Fitted.
    clean, odd : int
        Numbers of frames; fewer where an odd mask shows nobody who could be described.
    rng : numpy.random.Generator
    """
    pool = _Pool(takes, max(clean, odd // 2), rng)
    masks, poses = pool.masks[:clean], list(pool.x[:clean])
    kinds = ["clean"] * len(masks)
    every = [*ODD, *FREQUENT, *(RENDERED if pool.can_render else ())]
    for k, kind in enumerate(every):
        count = len(range(k, odd, len(every)))
        made = pool.rendered(kind, count) if kind in RENDERED else pool.odd(kind, count)
        masks += [mask for mask, _ in made]
        poses += [x for _, x in made]
        kinds += [kind] * len(made)
    return _described(descriptor, masks, np.array(poses), kinds)


class _Pool:
    """Frames drawn of takes, of which odd ones are made."""

    def __init__(self, takes: Sequence[Take], count: int, rng: np.random.Generator) -> None:
        self._takes, self._rng = takes, rng
        lengths = [len(take) for take in takes]
        drawn = rng.permutation(sum(lengths))[:count]
        take_of = np.repeat(np.arange(len(takes)), lengths)[drawn]
        before = np.cumsum(lengths) - lengths
        frames = (drawn - before[take_of]).astype(np.intp)
        masks: list[Mask | None] = [None] * len(drawn)
        for k, take in enumerate(takes):  # a take at a time, as masks may have to be rendered
            own = np.flatnonzero(take_of == k)
            for place, mask in zip(own.tolist(), take.masks_at(frames[own]), strict=True):
                masks[place] = mask
        self.masks: list[Mask] = [mask for mask in masks if mask is not None]
        self.x = np.array([takes[k].x[f] for k, f in zip(take_of, frames, strict=True)])
        self.can_render = all(
            take.camera is not None and take.x.shape[1] == len(ANGLES.columns) for take in takes
        )

    def odd(self, kind: str, count: int) -> list[tuple[Mask, Array]]:
        """Make odd masks; their poses are NaN where nobody is in them."""
        made = []
        for mine, other in self._rng.integers(len(self.masks), size=(count, 2)):
            odd = odd_mask(kind, self.masks[mine], self.masks[other], self._rng)
            made.append(
                (odd, np.full_like(self.x[mine], np.nan) if kind in NOBODY else self.x[mine])
            )
        return made

    def rendered(self, kind: str, count: int) -> list[tuple[Mask, Array]]:
        """Render poses that are bent, or of another build, or seen from higher up."""
        made: list[tuple[Mask, Array]] = []
        for scene in range(_SCENES):
            take = self._takes[int(self._rng.integers(len(self._takes)))]
            frames = self._rng.integers(len(take), size=len(range(scene, count, _SCENES)))
            x, camera, body = take.x[frames], take.camera, Body(level=2)
            assert camera is not None
            if kind == "bent":
                x = ANGLES.from_angles(odd_poses(ANGLES.angles(x), self._rng))
            elif kind == "build":
                direction = self._rng.standard_normal(10)
                shape = direction / np.linalg.norm(direction) * self._rng.uniform(*_BUILD)
                body = Body(level=2, shape=shape.tolist())
            else:
                higher = camera.elevation + float(self._rng.uniform(*_ELEVATION))
                camera = replace(camera, elevation=min(higher, 80.0))
            made += zip(render(body, camera, ANGLES.rotations(x)), x, strict=True)
        return made


def _described(
    descriptor: ShapeContextHistogram, masks: Sequence[Mask], x: Array, kinds: Sequence[str]
) -> Frames:
    """Describe masks that show a person, or something as large."""
    alone, facts = facts_of(masks)
    seen = np.flatnonzero(facts.seen)
    shown, own = [alone[f] for f in seen.tolist()], [kinds[f] for f in seen.tolist()]
    odd = np.array([kind != "clean" for kind in own])
    return Frames(descriptor.transform(shown), x[seen], facts[seen], odd, own)


def facts_of(masks: Sequence[Mask]) -> tuple[list[Mask], MaskFacts]:
    """Keep the largest person of each mask by itself, and say what is in each."""
    selected = [PersonSelector("largest").step(mask) for mask in masks]
    return [mask for mask, _ in selected], MaskFacts.concatenate([own for _, own in selected])


def frames_of_descriptors(
    z: Array, x: Array, clean: int, odd: int, rng: np.random.Generator
) -> Frames:
    """Draw frames of which there are descriptors only; odd ones are mixtures and noise.

    Parameters
    ----------
    z, x : ndarray, shapes (n, d) and (n, D)
    clean, odd : int
    rng : numpy.random.Generator
    """
    chosen = rng.integers(len(z), size=clean)
    first, second = rng.integers(len(z), size=(2, odd))
    share = rng.uniform(0, 0.5, (odd, 1))
    share[::4] = 1  # a quarter is noise of the same sum
    noise = rng.gamma(0.5, size=(odd, z.shape[1]))
    noise *= z[first].sum(axis=1, keepdims=True) / noise.sum(axis=1, keepdims=True)
    mixed = (1 - share) * z[first] + share * np.where(share == 1, noise, z[second])
    poses = np.where(share == 1, np.nan, x[first])
    flags = np.arange(clean + odd) >= clean
    kinds = ["clean"] * clean + ["mixed"] * odd
    return Frames(
        np.concatenate([z[chosen], mixed]), np.concatenate([x[chosen], poses]), None, flags, kinds
    )
