"""Different poses whose silhouettes are nearly the same: Fig. 1 of the paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Self

import cv2
import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from silpose.core.errors import InputError
from silpose.core.pose_space import PoseSpace
from silpose.core.stages import stage
from silpose.core.types import Array, Mask
from silpose.dataset import Dataset
from silpose.evaluation import heading_errors
from silpose.experiments.figures import draw_silhouette, draw_skeleton, headline, without_ink
from silpose.experiments.setup import Components, want_masks
from silpose.recording import Recording, Result, palette, record_study
from silpose.recording.figure_style import styled
from silpose.silhouette import Camera

_GRID = 64  # rows and columns of the small masks by which all pairs are compared
_TURN = 70.0  # degrees by which the pose is turned to be seen from the side


@dataclass(frozen=True)
class Frames:
    """Some frames of a dataset.

    Attributes
    ----------
    names : list of str
        Take and frame.
    masks : ndarray, shape (n, H, W)
    x : ndarray, shape (n, D)
        True poses.
    cameras : list of Camera
        The one in front of which each was rendered.
    """

    names: list[str]
    masks: NDArray[np.uint8]
    x: Array
    cameras: list[Camera]

    @classmethod
    def sample(cls, data: Dataset, count: int, default_camera: Camera) -> Self:
        """Choose about so many training frames, evenly."""
        every = max(1, sum(map(len, data.train)) // count)
        parts = [(take, np.arange(0, len(take), every)) for take in data.train]
        return cls(
            [f"{take.name}, frame {frame}" for take, frames in parts for frame in frames],
            np.concatenate([take.masks[::every] for take, _ in parts if take.masks is not None]),
            np.concatenate([take.x[frames] for take, frames in parts]),
            [take.camera_or(default_camera) for take, frames in parts for _ in frames],
        )


def lookalikes(
    components: Components, *, pairs: int = 4, overlap: float = 0.85, frames: int = 1500
) -> Result:
    """Find the training frames whose silhouettes agree most and whose poses agree least.

    Parameters
    ----------
    components : Components
    pairs : int, default=4
        Number of pairs that are shown.
    overlap : float, default=0.85
        Intersection over union from which two silhouettes count as nearly the same.
    frames : int, default=1500
        Number of training frames that are searched.
    """
    if not 0 < overlap < 1 or pairs < 1 or frames < 2:
        raise InputError("overlap is between 0 and 1, pairs at least 1 and frames at least 2")
    data = components.load()
    want_masks(data.train, "lookalikes")
    space = data.space
    with stage("search"):
        seen = Frames.sample(data, frames, components.camera)
        small = _small_overlaps(seen.masks)
        apart = space.pairwise(seen.x, seen.x)
        found = _most_different(seen, small, apart, pairs, overlap)
        if not found:
            raise InputError(f"no two silhouettes overlap by {overlap}: lower overlap")
        np.fill_diagonal(small, 0)
        similar = apart[np.arange(len(apart)), small.argmax(axis=1)]
        np.fill_diagonal(apart, np.inf)
    metrics = {
        f"{seen.names[i]}; {seen.names[j]}": {
            "overlap": _overlap(seen.masks[i], seen.masks[j]),
            "poses_apart_deg": float(space.distance(seen.x[i], seen.x[j])),
            "heading_mean_deg": float(heading_errors(space, seen.x[i], seen.x[j])),
        }
        for i, j in found
    }
    record = partial(
        record_study,
        series={
            "pose of the most similar silhouette": similar,
            "most similar pose": apart.min(axis=1),
        },
        title="how far poses are apart, degrees",
        frames_per_second=data.train[0].frames_per_second,
    )
    return Result(
        data.name,
        metrics,
        figure=_figure(space, seen, found),
        recording=Recording("pairs of poses with nearly the same silhouette", record),
    )


def _small_overlaps(masks: NDArray[np.uint8]) -> Array:
    """Intersection over union of all pairs, (n, n), of masks on a coarse grid."""
    rows, columns = (s // _GRID or 1 for s in masks.shape[1:])
    flat = masks[:, rows // 2 :: rows, columns // 2 :: columns].reshape(len(masks), -1)
    flat = flat.astype(np.float32)
    both, each = flat @ flat.T, flat.sum(axis=1)
    return (both / np.maximum(each[:, None] + each - both, 1)).astype(float)


def _overlap(one: Mask, other: Mask) -> float:
    return float((one & other).sum() / (one | other).sum())


def _most_different(
    seen: Frames, small: Array, apart: Array, pairs: int, overlap: float
) -> list[tuple[int, int]]:
    """Pairs of nearly the same silhouettes, the most different poses first, none like another."""
    first, second = np.nonzero(np.triu(small >= overlap, k=1))
    typical = np.quantile(apart, 0.1)
    found: list[tuple[int, int]] = []
    for k in np.argsort(-apart[first, second]):
        i, j = int(first[k]), int(second[k])
        known = [pose for pair in found for pose in pair]
        if known and min(apart[i, known].min(), apart[j, known].min()) < typical:
            continue
        if _overlap(seen.masks[i], seen.masks[j]) >= overlap:
            found.append((i, j))
            if len(found) == pairs:
                break
    return found


@styled
def _figure(space: PoseSpace, seen: Frames, found: Sequence[tuple[int, int]]) -> Figure:
    figure = Figure(figsize=(10, 2.6 * len(found) + 0.7), layout="constrained")
    side = Rotation.from_euler("Y", -_TURN, degrees=True)
    window = _window([seen.masks[k] for pair in found for k in pair])
    for line, (i, j) in zip(figure.subplots(len(found), 5, squeeze=False), found, strict=True):
        for axes, beside, k in zip(line[:2], line[3:], (i, j), strict=True):
            joints, camera = space.joints(seen.x[k : k + 1])[0], seen.cameras[k]
            draw_silhouette(axes, seen.masks[k])
            draw_skeleton(axes, space, camera.project(joints), palette.TRUE, 2.2)
            axes.set_title(seen.names[k].replace(", ", "\n"), fontsize=9, loc="center")
            beside_joints = camera.project(side.apply(joints))
            draw_skeleton(beside, space, beside_joints, palette.TRUE, 2.2)
        line[2].imshow(1 - 0.4 * seen.masks[i] - 0.4 * seen.masks[j], cmap="gray", vmin=0, vmax=1)
        overlap = _overlap(seen.masks[i], seen.masks[j])
        line[2].set_title(f"both:\noverlap {overlap:.0%}", fontsize=9, loc="center")
        for axes, which in zip(line[3:], ("first", "second"), strict=True):
            title = f"the {which}, seen\nfrom {_TURN:.0f}° beside"
            axes.set_title(title, fontsize=9, loc="center")
        for axes in line:
            axes.set(xlim=window[:2], ylim=window[2:], aspect="equal")
            without_ink(axes)
    headline(
        figure, "Different poses with nearly the same silhouette",
        "Left limbs are light, right limbs dark",
    )  # fmt: skip
    return figure


def _window(masks: Sequence[Mask]) -> tuple[float, float, float, float]:
    """Left, right, bottom and top of what holds the person in all masks, and a turned one."""
    left, top, width, height = cv2.boundingRect(np.any(masks, axis=0).astype(np.uint8))
    middle, half = left + width / 2, max(width, 0.6 * height) / 2
    margin = 0.05 * height
    return middle - half - margin, middle + half + margin, top + height + margin, top - margin
