"""Different poses whose silhouettes are nearly the same: Fig. 1 of the paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from silpose.core.errors import InputError
from silpose.core.pose_space import PoseSpace, wrap_degrees
from silpose.dataset import Dataset
from silpose.experiments.setup import Components, want_masks
from silpose.recording import record_study
from silpose.recording.runs.run_folder import Run

Array = NDArray[np.float64]

_LEFT, _RIGHT, _MIDDLE = "#2f8fd0", "#e8792b", "#5f6670"
_GRID = 64  # rows and columns of the small masks by which all pairs are compared
_TURN = 70.0  # degrees by which the pose is turned to be seen from beside


@dataclass(frozen=True)
class Frames:
    """Some frames of a dataset: which, their masks and their poses."""

    names: list[str]
    masks: NDArray[np.uint8]
    x: Array

    @classmethod
    def sample(cls, data: Dataset, count: int) -> Frames:
        """Take frames of training, evenly."""
        every = max(1, sum(map(len, data.train)) // count)
        parts = [(take, np.arange(0, len(take), every)) for take in data.train]
        return cls(
            [f"{take.name}, frame {frame}" for take, frames in parts for frame in frames],
            np.concatenate([take.masks[::every] for take, _ in parts if take.masks is not None]),
            np.concatenate([take.x[frames] for take, frames in parts]),
        )


def lookalikes(rooms: Components, run: Run, pairs: int, overlap: float, frames: int) -> None:
    """Search training for the silhouettes that agree most about the least agreeing poses.

    Parameters
    ----------
    rooms : Components
    run : Run
    pairs : int
        To be shown.
    overlap : float
        Intersection over union from which two silhouettes count as nearly the same.
    frames : int
        Of training to search.
    """
    if not 0 < overlap < 1 or pairs < 1 or frames < 2:
        raise InputError("overlap is between 0 and 1, pairs at least 1 and frames at least 2")
    with run.stage("masks"):
        data = rooms.dataset()
    want_masks(data.train, run)
    with run.stage("search"):
        seen = Frames.sample(data, frames)
        small = _small_overlaps(seen.masks)
        far = data.space.pairwise(seen.x, seen.x)
        found = _most_different(seen, small, far, pairs, overlap)
        if not found:
            raise InputError(f"no two silhouettes overlap by {overlap}: lower overlap")
        np.fill_diagonal(small, 0)
        alike = far[np.arange(len(far)), small.argmax(axis=1)]
        np.fill_diagonal(far, np.inf)
        series = {"pose of the most similar silhouette": alike, "most similar pose": far.min(1)}
    metrics = {
        f"{seen.names[i]}; {seen.names[j]}": {
            "overlap": _overlap(seen.masks[i], seen.masks[j]),
            data.space.metrics[0]: float(data.space.distance(seen.x[i], seen.x[j])),
            "heading_mean_deg": _heading_apart(data.space, seen.x[i], seen.x[j]),
        }
        for i, j in found
    }
    with run.writing("lookalikes.png") as path:
        _figure(path, rooms, data.space, seen, found)
    record_study(
        run.header("pairs of poses with nearly the same silhouette", metrics),
        run.folder / "lookalikes.png",
        series,
        "how far each sampled pose is from that of the most similar silhouette, degrees",
        data.train[0].frames_per_second,
    )
    run.write_settings()
    run.write_metrics(data.name, rooms.seed, metrics)


def _small_overlaps(masks: NDArray[np.uint8]) -> Array:
    """Intersection over union of all pairs, (n, n), of masks brought down to a coarse grid."""
    rows, columns = (s // _GRID or 1 for s in masks.shape[1:])
    flat = masks[:, rows // 2 :: rows, columns // 2 :: columns].reshape(len(masks), -1)
    flat = flat.astype(np.float32)
    both, each = flat @ flat.T, flat.sum(axis=1)
    return (both / np.maximum(each[:, None] + each - both, 1)).astype(float)


def _overlap(one: NDArray[np.uint8], other: NDArray[np.uint8]) -> float:
    return float((one & other).sum() / (one | other).sum())


def _heading_apart(space: PoseSpace, one: Array, other: Array) -> float:
    return float(np.abs(wrap_degrees(space.heading(one) - space.heading(other))))


def _most_different(
    seen: Frames, small: Array, far: Array, pairs: int, overlap: float
) -> list[tuple[int, int]]:
    """Pairs of nearly the same silhouettes, the most different poses first, none like another."""
    first, second = np.nonzero(np.triu(small >= overlap, k=1))
    typical = np.quantile(far, 0.1)
    found: list[tuple[int, int]] = []
    for k in np.argsort(-far[first, second]):
        i, j = int(first[k]), int(second[k])
        known = [pose for pair in found for pose in pair]
        if known and min(far[i, known].min(), far[j, known].min()) < typical:
            continue
        if _overlap(seen.masks[i], seen.masks[j]) >= overlap:
            found.append((i, j))
            if len(found) == pairs:
                break
    return found


def _figure(
    path: Path, rooms: Components, space: PoseSpace, seen: Frames, found: Sequence[tuple[int, int]]
) -> None:
    figure = Figure(figsize=(9.5, 2.5 * len(found) + 0.5), layout="constrained")
    for line, (i, j) in zip(figure.subplots(len(found), 5, squeeze=False), found, strict=True):
        for axes, k in zip(line[:2], (i, j), strict=True):
            axes.imshow(1 - 0.22 * seen.masks[k], cmap="gray", vmin=0, vmax=1)
            _draw(axes, space, rooms.camera.project(space.joints(seen.x[k : k + 1])[0]))
            axes.set_title(seen.names[k], fontsize=8)
        only = 0.45 * seen.masks[i] + 0.45 * seen.masks[j]
        line[2].imshow(1 - only, cmap="gray", vmin=0, vmax=1)
        line[2].set_title(f"overlap {_overlap(seen.masks[i], seen.masks[j]):.0%}", fontsize=8)
        beside = Rotation.from_euler("Y", -_TURN, degrees=True)
        for axes, k in zip(line[3:], (i, j), strict=True):
            turned = beside.apply(space.joints(seen.x[k : k + 1])[0])
            _draw(axes, space, rooms.camera.project(turned))
            axes.set_title(f"seen from {_TURN:.0f}° beside", fontsize=8)
        for axes in line:
            axes.set(xlim=(0.15 * rooms.camera.width, 0.85 * rooms.camera.width))
            axes.set(ylim=(rooms.camera.height, 0), aspect="equal")
            axes.axis("off")
    figure.suptitle(
        "nearly the same silhouette, different poses; left limbs blue, right limbs orange",
        fontsize=10,
    )
    figure.savefig(path, dpi=120, format="png")


def _draw(axes: Axes, space: PoseSpace, pixels: NDArray[np.floating]) -> None:
    for bone in space.bones:
        side = space.joint_names[bone[1]].split("_")[0]
        colour = {"left": _LEFT, "right": _RIGHT}.get(side, _MIDDLE)
        axes.plot(*pixels[list(bone)].T, color=colour, lw=2.2, solid_capstyle="round")
