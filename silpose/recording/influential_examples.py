"""The training examples that contribute most to an estimate, frame by frame."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import cv2
import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array, Indices, Mask
from silpose.recording import entity_paths, palette

if TYPE_CHECKING:
    from silpose.dataset import Take
    from silpose.model import PredictionDetails
    from silpose.recording.frame_logger import FrameLogger
    from silpose.regression import Regressor
    from silpose.silhouette import Camera

COUNT = 5  # examples shown side by side
_SIZE = 100.0  # pixels that a metre, or half of an image's height, is drawn in


@dataclass(frozen=True)
class InfluentialExamples:
    """Training examples that contribute most to estimates.

    Attributes
    ----------
    outlines : list of list of ndarray, each (N, 2)
        Outlines of each relevance vector's silhouette, in an image of 100 pixels a metre; empty
        without masks.
    bones : ndarray, shape (k, B, 2, 2)
        Bones of each relevance vector's pose, in the same image.
    chosen : ndarray of int, shape (F, COUNT)
        Relevance vectors of largest weight for each frame.
    weight : ndarray, shape (F, COUNT)
        Share of the frame's activations times the size of their coefficients, which is how far
        each moves the estimate.
    """

    outlines: list[list[Array]]
    bones: Array
    chosen: Indices
    weight: Array

    @classmethod
    def of(
        cls,
        regressor: Regressor,
        details: PredictionDetails,
        training: Sequence[Take],
        camera: Camera,
        space: PoseSpace,
    ) -> InfluentialExamples | None:
        """Find the examples behind a prediction.

        Parameters
        ----------
        regressor : Regressor
        details : PredictionDetails
            Prediction that is explained.
        training : sequence of Take
            Takes that the regressor was fitted to, in their order.
        camera : Camera
            Camera that rendered the takes that have none of their own.
        space : PoseSpace

        Returns
        -------
        examples : InfluentialExamples or None
            None for a regressor that keeps fewer training examples than are shown.
        """
        rows = regressor.basis_.indices_
        if len(rows) < COUNT:
            return None
        x = np.concatenate([take.x for take in training])
        reach = np.linalg.norm(
            regressor.coef_[: len(rows)] / np.maximum(x.std(axis=0), 1e-9), axis=1
        )
        moved = np.nan_to_num(details.activations[:, : len(rows)]) * reach
        chosen = np.argsort(-moved, axis=1)[:, :COUNT]
        total = np.maximum(moved.sum(axis=1, keepdims=True), 1e-12)
        weight = np.take_along_axis(moved, chosen, axis=1) / total
        outlines, bones = _drawings(training, rows, camera, space)
        return cls(outlines, bones, chosen, weight)


def _drawings(
    training: Sequence[Take], rows: Indices, camera: Camera, space: PoseSpace
) -> tuple[list[list[Array]], Array]:
    """Outlines, and bones ``(k, B, 2, 2)``, of some rows of the training data."""
    outlines: list[list[Array]] = [[] for _ in rows]
    bones = np.empty((len(rows), len(space.bones), 2, 2))
    first = 0
    for take in training:
        own = np.flatnonzero((first <= rows) & (rows < first + len(take)))
        strips, bones[own] = _of_take(take, rows[own] - first, camera, space)
        for k, strip in zip(own, strips, strict=True):
            outlines[k] = strip
        first += len(take)
    return outlines, bones


def _of_take(
    take: Take, frames: Indices, camera: Camera, space: PoseSpace
) -> tuple[list[list[Array]], Array]:
    """Outlines and bones ``(F, B, 2, 2)`` of some frames of a take."""
    joints = space.joints(take.x[frames])
    bones = np.asarray(space.bones)
    if take.masks is None:  # the camera is unknown: draw the poses from the front
        flat = _SIZE * np.array([0.5, 1.0]) + 0.9 * _SIZE * joints[..., :2] * [1, -1]
        return [[] for _ in frames], flat[:, bones]
    own = take.camera_or(camera)
    scale = 2 * _SIZE / own.height
    middle = np.array([own.width / 2 - own.height / 4, 0])
    flat = scale * (own.project(joints + take.offset[frames][:, None]) - middle)
    outlines = [
        [scale * (strip - middle) for strip in _outlines(mask)] for mask in take.masks_at(frames)
    ]
    return outlines, flat[:, bones]


def _outlines(mask: Mask) -> list[Array]:
    """Find the closed outlines (N, 2) of a mask, pixels, without points that add little."""
    contours, _ = cv2.findContours(mask, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    short = [cv2.approxPolyDP(c, 1.0, closed=True)[:, 0] for c in contours]
    return [np.vstack([c, c[:1]]).astype(float) for c in short if len(c) > 2]


def log_influential_examples(
    logger: FrameLogger, examples: InfluentialExamples, space: PoseSpace
) -> None:
    """Log the examples side by side, that of the largest weight on the left."""
    shifts = _SIZE * np.arange(COUNT)[:, None] * [1.0, 0.0]
    outlines: list[NDArray[np.float32]] = []
    counts = []
    for chosen in examples.chosen:
        strips = [
            strip + shift
            for k, shift in zip(chosen, shifts, strict=True)
            for strip in examples.outlines[k]
        ]
        outlines.extend(strip.astype(np.float32) for strip in strips)
        counts.append(len(strips))
    if outlines:
        logger.strips(entity_paths.INFLUENTIAL_OUTLINES, outlines, counts, palette.EDGE, 0.8)
    bones = examples.bones[examples.chosen] + shifts[:, None, None]  # (F, COUNT, B, 2, 2)
    sides = [space.joint_names[child].split("_")[0] for _, child in space.bones]
    colours = [palette.shade(palette.TRUE, side) for side in sides] * COUNT
    logger.strips(
        entity_paths.INFLUENTIAL_SKELETONS,
        bones.reshape(-1, 2, 2).astype(np.float32),
        [COUNT * len(space.bones)] * len(bones),
        colours,
        1.5,
    )
    below = np.array([_SIZE / 2, 2 * _SIZE])
    labels = [f"{w:.0%}" for w in examples.weight.ravel()]
    logger.labels(entity_paths.INFLUENTIAL_WEIGHTS, shifts + below, labels)
