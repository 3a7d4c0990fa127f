"""What training data looks like: sampled silhouettes of many bodies before many cameras."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import cycle
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.dataset import Scene, photograph
from silpose.experiments.setup import Components, studio_of
from silpose.recording import record_study
from silpose.recording.runs.run_folder import Run
from silpose.silhouette import BODIES, DEGRADATIONS, LEVELS, Body, Camera, degrade

Mask = NDArray[np.uint8]


def contact_sheet(
    rooms: Components, run: Run, cameras: int, bodies: int, strengths: Sequence[float]
) -> None:
    """Photograph training poses: one a column, before the column's camera, by the row's body.

    Parameters
    ----------
    rooms : Components
        Of motion; ``silhouette.scenes`` is what bodies and cameras are drawn from.
    run : Run
    cameras : int
        Columns.
    bodies : int
        Rows of drawn shapes, below one of each kind and level of detail.
    strengths : sequence of float
        Of rows of degradations, each column suffering another kind.
    """
    studio = studio_of(rooms, run)
    if min(cameras, bodies) < 1:
        raise InputError("cameras and bodies must be at least 1")
    with run.stage("masks"):
        takes = [studio.takes[k % len(studio.takes)] for k in range(max(cameras, bodies))]
        shots = replace(studio.scenes, frames=None).shots(takes, studio.body, studio.camera)
        rows = _kinds() + [(_shape_text(shot.body), shot.body) for shot in shots[:bodies]]
        columns = shots[:cameras]
        sheet = [[_mask(shot, body) for shot in columns] for _, body in rows]
        whole, names = sheet[0], [text for text, _ in rows]
        for strength in strengths:
            rng = np.random.default_rng(rooms.seed)  # the same damage, only more of it
            sheet.append([degrade(m, k, strength, rng) for m, k in zip(whole, cycle(DEGRADATIONS))])
            names.append(f"degraded by {strength:g}")
    with run.writing("contact_sheet.png") as path:
        _figure(path, sheet, names, [_camera_text(shot.camera) for shot in columns])
    header = run.header(f"{len(rows)} bodies, {len(columns)} cameras", {})
    record_study(header, run.folder / "contact_sheet.png", {}, "", 15.0)
    run.write_settings()
    run.write_metrics(studio.name, rooms.seed, {})


def _mask(shot: Scene, body: Body) -> Mask:
    """Photograph the middle frame of a shot, with another body."""
    middle = len(shot.motion) // 2
    masks = photograph(shot.motion.part(middle, middle + 1), body, shot.camera).masks
    assert masks is not None
    return masks[0]


def _kinds() -> list[tuple[str, Body]]:
    """Give the mean body of every kind and level of detail."""
    convex = [(f"convex, level {level}", Body("convex", level)) for level in LEVELS]
    return convex + [(kind, Body(kind)) for kind in BODIES if kind != "convex"]


def _shape_text(body: Body) -> str:
    return f"shape of length {np.linalg.norm(body.shape or 0):.1f}"


def _camera_text(camera: Camera) -> str:
    return f"{camera.elevation:.0f}° down, f {camera.focal_length:.1f}\nat {camera.distance:.1f} m"


def _figure(
    path: Path, sheet: Sequence[Sequence[Mask]], rows: Sequence[str], columns: Sequence[str]
) -> None:
    figure = Figure(figsize=(0.95 * len(columns) + 1.5, 1.4 * len(rows) + 0.5))
    grid = figure.subplots(len(rows), len(columns), squeeze=False)
    figure.subplots_adjust(left=0.13, right=0.995, bottom=0.04, top=0.955, wspace=0.03, hspace=0.03)
    for line, masks, text in zip(grid, sheet, rows, strict=True):
        for axes, mask in zip(line, masks, strict=True):
            axes.imshow(1 - mask, cmap="gray", vmin=-0.15, vmax=1)
            height, width = mask.shape
            axes.set(xticks=[], yticks=[], xlim=(0.22 * width, 0.78 * width))
            axes.set_ylim(0.97 * height, 0.05 * height)
            axes.spines[:].set_color("#c8ccd0")
        line[0].set_ylabel(text, fontsize=8, rotation=0, ha="right", va="center")
    for axes, text in zip(grid[0], columns, strict=True):
        axes.set_title(text, fontsize=7)
    for axes, kind in zip(grid[-1], cycle(DEGRADATIONS)):
        axes.set_xlabel(kind.replace("_", "\n"), fontsize=7)
    figure.savefig(path, dpi=120, format="png")
