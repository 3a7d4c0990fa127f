"""Why this pose? The training examples that speak loudest for an estimate, frame by frame."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import cv2
import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.dataset import Take
from silpose.recording import entity_paths, palette
from silpose.regression import Regressor
from silpose.silhouette import Camera

if TYPE_CHECKING:
    from silpose.model.pose_model import PredictionDetails
    from silpose.recording.frame_logger import FrameLogger

Array = NDArray[np.float64]

COUNT = 5  # examples shown side by side
_SIZE = 100.0  # pixels that a metre, or half of an image's height, is drawn in


@dataclass(frozen=True)
class Reasons:
    """Training examples behind estimates.

    Attributes
    ----------
    outlines : list of list of ndarray, each (N, 2)
        Of each relevance vector's silhouette, its image two by two; none without masks.
    bones : ndarray, shape (k, B, 2, 2)
        Of its pose, in the same picture.
    chosen : ndarray of int, shape (F, COUNT)
        Relevance vectors of largest weight for each frame.
    weight : ndarray, shape (F, COUNT)
        Share of the frame's activations times the size of their coefficients, which is how far
        each moves the estimate.
    """

    outlines: list[list[Array]]
    bones: Array
    chosen: NDArray[np.intp]
    weight: Array

    @classmethod
    def of(
        cls,
        regressor: Regressor,
        look: PredictionDetails,
        training: Sequence[Take],
        camera: Camera,
        space: PoseSpace,
    ) -> Reasons | None:
        """Find them; None for a regressor that keeps no training examples."""
        rows = regressor.basis_.indices_
        if len(rows) < COUNT:
            return None
        x = np.concatenate([take.x for take in training])
        reach = np.linalg.norm(
            regressor.coef_[: len(rows)] / np.maximum(x.std(axis=0), 1e-9), axis=1
        )
        moved = np.nan_to_num(look.activations[:, : len(rows)]) * reach
        chosen = np.argsort(-moved, axis=1)[:, :COUNT]
        total = np.maximum(moved.sum(axis=1, keepdims=True), 1e-12)
        weight = np.take_along_axis(moved, chosen, axis=1) / total
        outlines, bones = _drawings(training, rows, camera, space)
        return cls(outlines, bones, chosen, weight)


def _drawings(
    training: Sequence[Take], rows: NDArray[np.intp], camera: Camera, space: PoseSpace
) -> tuple[list[list[Array]], Array]:
    starts = np.cumsum([0, *(len(take) for take in training)])
    bones: list[Array] = []
    outlines: list[list[Array]] = []
    for row in rows:
        k = int(np.searchsorted(starts, row, side="right")) - 1
        take, frame = training[k], row - starts[k]
        camera = take.camera or camera
        joints = space.joints(take.x[frame : frame + 1])[0]
        if take.masks is None:  # nobody knows the camera: look straight at it
            flat = _SIZE * np.array([0.5, 1.0]) + 0.9 * _SIZE * joints[:, :2] * [1, -1]
            outlines.append([])
        else:
            scale = 2 * _SIZE / camera.height
            middle = np.array([camera.width / 2 - camera.height / 4, 0])
            flat = scale * (camera.project(joints + take.offset[frame]) - middle)
            contours, _ = cv2.findContours(take.masks[frame], cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
            short = [cv2.approxPolyDP(c, 1.0, closed=True)[:, 0] for c in contours]
            outlines.append([scale * (np.vstack([c, c[:1]]) - middle) for c in short if len(c) > 2])
        bones.append(flat[np.asarray(space.bones)])
    return outlines, np.stack(bones)


def log_reasons(track: FrameLogger, reasons: Reasons, space: PoseSpace) -> None:
    """Log the examples side by side, the weightiest on the left."""
    shifts = _SIZE * np.arange(COUNT)[:, None] * [1.0, 0.0]
    outlines: list[NDArray[np.float32]] = []
    counts = []
    for chosen in reasons.chosen:
        strips = [
            strip + shift
            for k, shift in zip(chosen, shifts, strict=True)
            for strip in reasons.outlines[k]
        ]
        outlines.extend(strip.astype(np.float32) for strip in strips)
        counts.append(len(strips))
    if outlines:
        track.strips(entity_paths.REASONS_OUTLINES, outlines, counts, palette.EDGE, 0.8)
    bones = reasons.bones[reasons.chosen] + shifts[:, None, None]  # (F, COUNT, B, 2, 2)
    sides = [space.joint_names[child].split("_")[0] for _, child in space.bones]
    colours = [palette.shade(palette.TRUE, side) for side in sides] * COUNT
    track.strips(
        entity_paths.REASONS_SKELETONS,
        bones.reshape(-1, 2, 2).astype(np.float32),
        [COUNT * len(space.bones)] * len(bones),
        colours,
        1.5,
    )
    below = np.array([_SIZE / 2, 2 * _SIZE])
    labels = [f"{w:.0%}" for w in reasons.weight.ravel()]
    track.labels(entity_paths.REASONS_WEIGHTS, shifts + below, labels)
