"""What training data look like: silhouettes of many bodies in front of many cameras."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from itertools import cycle

import numpy as np
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from silpose.core.parameters import FROM_0_TO_1, POSITIVE_INTEGER, check_values
from silpose.core.stages import stage
from silpose.core.types import Mask
from silpose.dataset import Scene, render_take
from silpose.experiments.figures import headline
from silpose.experiments.setup import Components, renderer_of
from silpose.recording import Recording, Result, record_study
from silpose.recording.figure_style import HAIRLINE, styled
from silpose.silhouette import BODIES, DEGRADATIONS, LEVELS, Body, Camera, degrade


def contact_sheet(
    components: Components,
    *,
    cameras: int = 9,
    bodies: int = 4,
    strengths: Sequence[float] = (0.3, 0.7),
) -> Result:
    """Render training poses: one a column, in front of the column's camera, with the row's body.

    Parameters
    ----------
    components : Components
        Bodies and cameras are drawn from ``silhouette.scenes``.
    cameras : int, default=9
        Number of columns.
    bodies : int, default=4
        Number of rows of drawn shapes, below one of each kind and level of detail.
    strengths : sequence of float, default=(0.3, 0.7)
        Strengths of rows of degradations, another kind in each column.
    """
    renderer = renderer_of(components, "contact_sheet")
    check_values("cameras", POSITIVE_INTEGER, cameras)
    check_values("bodies", POSITIVE_INTEGER, bodies)
    for strength in strengths:
        check_values("strengths", FROM_0_TO_1, strength)
    with stage("masks"):
        takes = [renderer.takes[k % len(renderer.takes)] for k in range(max(cameras, bodies))]
        sampler = replace(renderer.scenes, frames=None)
        scenes = sampler.draw(takes, renderer.body, renderer.camera)
        columns = scenes[:cameras]
        rows = _kinds() + [(_shape_in_words(scene.body), scene.body) for scene in scenes[:bodies]]
        sheet = [[_mask(scene, body) for scene in columns] for _, body in rows]
        clean, titles = sheet[0], [title for title, _ in rows]
        for strength in strengths:
            rng = np.random.default_rng(components.seed)  # the same damage, only more of it
            sheet.append(
                [degrade(m, kind, strength, rng) for m, kind in zip(clean, cycle(DEGRADATIONS))]
            )
            titles.append(f"degraded by {strength:g}")
    record = partial(record_study, series={}, title="", frames_per_second=15.0)
    return Result(
        components.dataset.full_name(renderer),
        {},
        figure=_figure(sheet, titles, [_camera_in_words(scene.camera) for scene in columns]),
        recording=Recording(f"{len(rows)} bodies, {len(columns)} cameras", record),
    )


def _mask(scene: Scene, body: Body) -> Mask:
    """Render the middle frame of a scene, with another body."""
    middle = len(scene.motion) // 2
    take = render_take(scene.motion.part(middle, middle + 1), body, scene.camera)
    return take.mask_array()[0]


def _kinds() -> list[tuple[str, Body]]:
    """List the mean body of every kind and level of detail, with titles."""
    convex = [(f"convex, level {level}", Body("convex", level)) for level in LEVELS]
    return convex + [(kind, Body(kind)) for kind in BODIES if kind != "convex"]


def _shape_in_words(body: Body) -> str:
    return f"shape of length {np.linalg.norm(body.shape or 0):.1f}"


def _camera_in_words(camera: Camera) -> str:
    return f"{camera.elevation:.0f}° down\nf {camera.focal_length:.1f}, {camera.distance:.1f} m"


@styled
def _figure(sheet: Sequence[Sequence[Mask]], rows: Sequence[str], columns: Sequence[str]) -> Figure:
    size = max(len(columns) + 1.6, 5), 1.15 * len(rows) + 1.4
    close = ConstrainedLayoutEngine(w_pad=0.03, h_pad=0.03, wspace=0, hspace=0)
    figure = Figure(figsize=size, layout=close)
    grid = figure.subplots(len(rows), len(columns), squeeze=False)
    for line, masks, title in zip(grid, sheet, rows, strict=True):
        for axes, mask in zip(line, masks, strict=True):
            axes.imshow(1 - mask, cmap="gray", vmin=-0.15, vmax=1)
            height, width = mask.shape
            axes.set(xticks=[], yticks=[], xlim=(0.1 * width, 0.9 * width))
            axes.set_ylim(0.98 * height, 0.02 * height)
            axes.spines[:].set(visible=True, color=HAIRLINE)
        line[0].set_ylabel(title, rotation=0, ha="right", va="center", fontsize=9)
    for axes, title in zip(grid[0], columns, strict=True):
        axes.set_title(title, fontsize=8, loc="center")
    for axes, kind in zip(grid[-1], cycle(DEGRADATIONS)):
        axes.set_xlabel(kind.replace("_", "\n"), fontsize=8)
    headline(
        figure, "What the silhouettes look like that are trained on",
        "A pose and a camera in each column (f: focal length), a body in each row; "
        "below, the first row degraded",
    )  # fmt: skip
    return figure
