"""Evidence for and against a pose: how the mask and the pose relate to those of training.

Three neighbourhoods are looked at: training silhouettes whose descriptors are similar, those that
look similar in a few pixels, and those whose poses are similar to the estimate. Where the estimate
is right, all three are close, and agree with each other.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Self

import cv2
import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.core.serialisation import State
from silpose.core.types import Array, Array32, Indices
from silpose.silhouette.person import MaskFacts

EVIDENCE = (
    "descriptor_distance", "descriptor_heading", "descriptor_joints", "descriptor_best",
    "look_distance", "look_heading", "look_joints", "look_best",
    "pose_distance", "pose_descriptor", "pose_look",
    "norm_low", "norm_high", "cut", "low_aspect", "high_aspect", "coarse",
)  # fmt: skip
"""Names of the evidence; each is larger the less a frame is like those of training."""

NEIGHBOURS = 8
"""Training examples in each neighbourhood."""

_LOOK = 12  # height and width of the pixels by which silhouettes are compared
_BLOCK = 256  # frames whose distances to all training examples are held at a time
_TINY = 1e-6
_FLIPPED = 0.85  # of the distance to looks of training: of people as they stand it is 0.9 and more
_USUAL = (0.005, 0.995)  # quantiles between which training's aspects are usual
_COARSE = 64.0  # pixels: a lower person is coarse


@dataclass(frozen=True, eq=False)
class TrainingExamples:
    """Training examples that evidence is gathered from.

    Attributes
    ----------
    roots : ndarray of float32, shape (n, d)
        Square roots of descriptors.
    looks : ndarray of float32, shape (n, 144)
        Thumbnails, of unit length.
    headings : ndarray of float32, shape (n, 2)
        Cosine and sine.
    joints : ndarray of float32, shape (n, 3 J)
        Joint positions, millimetres over the square root of J, so that distances are root mean
        squares.
    log_aspects : ndarray of float32, shape (n,)
        Logarithm of height over width.
    space : PoseSpace
    """

    roots: Array32
    looks: Array32
    headings: Array32
    joints: Array32
    log_aspects: Array32
    space: PoseSpace

    @classmethod
    def of(cls, z: Array, x: Array, facts: MaskFacts | None, space: PoseSpace) -> Self:
        """Prepare examples.

        Parameters
        ----------
        z, x : ndarray, shapes (n, d) and (n, D)
        facts : MaskFacts or None
            Of their masks; None where there are none, and looks are no evidence then.
        space : PoseSpace
        """
        return cls(
            np.sqrt(z).astype(np.float32), looks_of(facts, len(z)), _headings(x),
            _joints(space, x), _log_aspects(facts, len(z)), space,
        )  # fmt: skip

    @classmethod
    def concatenate(cls, parts: Sequence[Self]) -> Self:
        """Join examples of one space."""
        own = [part.to_arrays() for part in parts]
        arrays = {name: np.concatenate([each[name] for each in own]) for name in own[0]}
        return cls(**arrays, space=parts[0].space)

    def to_arrays(self) -> State:
        """Everything but the space, by name, as the constructor takes it."""
        return {f.name: getattr(self, f.name) for f in fields(self) if f.name != "space"}

    def evidence(self, z: Array, x: Array, facts: MaskFacts | None) -> Array:
        """Gather evidence about poses.

        Parameters
        ----------
        z, x : ndarray, shapes (F, d) and (F, D)
            Finite descriptors and estimated poses.
        facts : MaskFacts or None
            Of the masks.

        Returns
        -------
        evidence : ndarray, shape (F, E)
            In the order of `EVIDENCE`.
        """
        parts = [
            self._evidence(z[f], x[f], None if facts is None else facts[f])
            for f in (slice(start, start + _BLOCK) for start in range(0, len(z), _BLOCK))
        ]
        return np.concatenate(parts) if parts else np.empty((0, len(EVIDENCE)))

    def upside_down(self, facts: MaskFacts) -> NDArray[np.bool_]:
        """Find masks that look clearly more like those of training when they are flipped, (F,)."""
        flipped = replace(facts, thumbnails=facts.thumbnails[:, ::-1])
        as_it_is, turned = (self._distance_of_looks(own) for own in (facts, flipped))
        return np.asarray(turned < _FLIPPED * as_it_is)

    def _distance_of_looks(self, facts: MaskFacts) -> Array:
        """Mean distance to the nearest looks of training, shape (F,)."""
        looks, lengths = looks_of(facts, len(facts.thumbnails)), self._squared_lengths[1]
        blocks = (looks[start : start + _BLOCK] for start in range(0, len(looks), _BLOCK))
        squared = (_squared(block, self.looks, lengths) for block in blocks)
        nearest = [np.take_along_axis(own, _smallest(own), 1) for own in squared]
        return np.asarray(np.sqrt(np.concatenate(nearest)).mean(axis=1), float)

    def _evidence(self, z: Array, x: Array, facts: MaskFacts | None) -> Array:
        own = type(self).of(np.maximum(z, 0), x, facts, self.space)
        by_descriptor, by_look, by_pose = (
            _squared(one, others, lengths)
            for one, others, lengths in zip(
                (own.roots, own.looks, own.joints),
                (self.roots, self.looks, self.joints),
                self._squared_lengths,
                strict=True,
            )
        )
        norm = self.space.heading_norm(x)
        columns = [
            *self._neighbourhood(by_descriptor, by_pose, own.headings),
            *self._neighbourhood(by_look, by_pose, own.headings),
            *self._of_similar_poses(by_pose, by_descriptor, by_look),
            np.maximum(1 - norm, 0),
            np.maximum(norm - 1, 0),
            *self._of_masks(own.log_aspects, facts, len(z)),
        ]
        return np.stack(columns, axis=1).astype(float)

    @cached_property
    def _squared_lengths(self) -> list[Array32]:
        return [np.einsum("nd,nd->n", a, a) for a in (self.roots, self.looks, self.joints)]

    @cached_property
    def _usual_aspects(self) -> tuple[float, float]:
        lowest, highest = np.quantile(self.log_aspects, _USUAL)
        return float(lowest), float(highest)

    def _neighbourhood(self, squared: Array32, by_pose: Array32, headings: Array32) -> list[Array]:
        """Distance to the nearest examples, and how far their poses are from the estimate."""
        nearest = _smallest(squared)
        away = np.sqrt(np.take_along_axis(squared, nearest, 1))
        apart = np.sqrt(np.take_along_axis(by_pose, nearest, 1))
        agreement = np.einsum("fkc,fc->f", self.headings[nearest], headings) / nearest.shape[1]
        return [
            _log(away.mean(axis=1)), 1 - agreement, _log(apart.mean(axis=1)),
            _log(apart.min(axis=1)),
        ]  # fmt: skip

    def _of_similar_poses(self, by_pose: Array32, *others: Array32) -> list[Array]:
        """Distance to similar poses, and of the mask to the masks that these have."""
        nearest = _smallest(by_pose)
        means = [np.sqrt(np.take_along_axis(by_pose, nearest, 1)).mean(axis=1)]
        means += [np.sqrt(np.take_along_axis(other, nearest, 1)).mean(axis=1) for other in others]
        return [_log(mean) for mean in means]

    def _of_masks(
        self, log_aspects: Array32, facts: MaskFacts | None, count: int
    ) -> list[NDArray[np.floating]]:
        if facts is None:
            return [np.zeros(count)] * 4
        lowest, highest = self._usual_aspects
        return [
            facts.cuts.sum(axis=1),
            np.maximum(lowest - log_aspects, 0),
            np.maximum(log_aspects - highest, 0),
            np.maximum(np.log(_COARSE / np.maximum(facts.height, 1)), 0),
        ]


def looks_of(facts: MaskFacts | None, count: int) -> Array32:
    """Thumbnails in fewer pixels and of unit length, shape (count, 144)."""
    if facts is None:
        return np.zeros((count, _LOOK * _LOOK), np.float32)
    small = [
        cv2.resize(thumbnail, (_LOOK, _LOOK), interpolation=cv2.INTER_AREA).ravel()
        for thumbnail in facts.thumbnails
    ]
    looks = np.array(small, np.float32).reshape(count, _LOOK * _LOOK)
    length = np.linalg.norm(looks, axis=1, keepdims=True)
    return np.asarray(looks / np.maximum(length, 1), np.float32)


def _log_aspects(facts: MaskFacts | None, count: int) -> Array32:
    if facts is None:
        return np.zeros(count, np.float32)
    return np.log(np.nan_to_num(facts.aspect, nan=1.0)).astype(np.float32)


def _headings(x: Array) -> Array32:
    length = np.maximum(np.hypot(x[:, :1], x[:, 1:2]), _TINY)
    return np.asarray(x[:, :2] / length, np.float32)


def _joints(space: PoseSpace, x: Array) -> Array32:
    joints = space.joints(x)
    scale = 1000 / np.sqrt(joints.shape[1])
    return (joints.reshape(len(x), -1) * scale).astype(np.float32)


def _squared(some: Array32, others: Array32, lengths: Array32) -> Array32:
    """Squared distances of all rows, shape (F, n), from the others' squared lengths."""
    own = np.einsum("fd,fd->f", some, some)[:, None]
    return np.maximum(own + lengths - 2 * some @ others.T, 0)


def _smallest(squared: Array32) -> Indices:
    count = min(NEIGHBOURS, squared.shape[1])
    return np.argpartition(squared, count - 1, axis=1)[:, :count]


def _log(values: NDArray[np.floating]) -> Array:
    return np.log(np.maximum(values, 1e-3)).astype(float)
