"""Layouts of recordings around a figure, and of those that explain the descriptor."""

from __future__ import annotations

from collections.abc import Sequence

import rerun.blueprint as rrb

from silpose.recording import entity_paths, palette
from silpose.recording.captions import coloured
from silpose.recording.layout.views import (
    Window,
    bars_view,
    blueprint,
    bodies_view,
    codebook_view,
    figure_view,
    histogram_view,
    mask_view,
    of_the_box,
    series_view,
    texts_view,
)


def study_layout(
    title: str | None,
    frames_per_second: float,
    masks: bool = False,
    window: Window | None = None,
    wide: bool = True,
    span: tuple[float, float] | None = None,
) -> rrb.Blueprint:
    """Lay out a figure and the errors behind it.

    Parameters
    ----------
    title : str or None
        Title of the errors; None for a figure alone.
    frames_per_second : float
    masks : bool, default=False
        Whether masks are recorded.
    window : tuple of float, optional
        Part of the masks that is shown.
    wide : bool, default=True
        Whether the figure stands above the errors, and not beside them from top to bottom.
    span : tuple of float, optional
        Lowest and highest error that there may be.
    """
    if title is None:
        return blueprint([figure_view(), texts_view()], [1.7, 1], frames_per_second)
    errors = series_view(title, [f"{entity_paths.ERROR}/**"], span)
    seen = [mask_view("silhouette", window)] if masks else []
    if not wide:
        beside = rrb.Vertical(texts_view(), *seen, errors, row_shares=[1.3, *(1 for _ in seen), 1])
        return blueprint([figure_view(), beside], [1.4, 1], frames_per_second)
    below = rrb.Horizontal(*seen, errors, column_shares=[*(1 for _ in seen), 2.4])
    shown = rrb.Vertical(figure_view(), below, row_shares=[1.6, 1])
    return blueprint([shown, texts_view()], [1.7, 1], frames_per_second)


def motion_layout(
    frames_per_second: float, low: Sequence[float], high: Sequence[float]
) -> rrb.Blueprint:
    """Lay out a take as it moves between two corners of its box, metres; behind it a figure."""
    eye = of_the_box(low, high)
    pose = bodies_view("pose; left side light, right side dark", [entity_paths.TRUE_SKELETON], eye)
    shown = rrb.Vertical(
        rrb.Tabs(pose, figure_view(), active_tab=0),
        series_view("heading, degrees", [entity_paths.TRUE_HEADING]),
        row_shares=[2.4, 1],
    )
    return blueprint([shown, texts_view()], [1.6, 1], frames_per_second)


def bridges_layout() -> rrb.Blueprint:
    """Lay out how the columns of an RVM vanish; a frame is an iteration."""
    shown = rrb.Vertical(
        figure_view(),
        bars_view(entity_paths.COLUMN_NORMS, "regression: size of every basis function's column"),
        rrb.Horizontal(
            series_view("columns left", [entity_paths.COLUMNS_LEFT]),
            series_view("objective (Eq. 5) of the columns left", [entity_paths.OBJECTIVE]),
        ),
        row_shares=[1.6, 1, 0.8],
    )
    return blueprint([shown, texts_view()], [1.7, 1], 2.0)


def features_layout(parts: Sequence[str], frames_per_second: float) -> rrb.Blueprint:
    """Lay out one image per body part, the silhouette and the points it retains; then the texts."""
    views = [
        rrb.Spatial2DView(
            origin=entity_paths.CAMERA,
            contents=[
                entity_paths.MASK,
                entity_paths.below(entity_paths.RETAINED_POINTS, part),
            ],
            name=part.replace("_", " "),
        )
        for part in parts
    ]
    return blueprint([rrb.Grid(*views, texts_view(), grid_columns=3)], [1], frames_per_second)


def context_space_layout(frames_per_second: float, window: Window) -> rrb.Blueprint:
    """Lay out a silhouette, where its edge points are among all contexts, and the codebook."""
    plane = rrb.Spatial2DView(
        origin=entity_paths.CONTEXT_SPACE,
        name=f"shape contexts: {coloured({'all': palette.NEUTRAL})}, centres (large), "
        "this silhouette's (small)",
        visual_bounds=rrb.VisualBounds2D(x_range=window[:2], y_range=window[2:]),
    )
    seen = rrb.Vertical(
        mask_view("edge points by nearest centre"), histogram_view(), row_shares=[2.2, 1]
    )
    beside = rrb.Vertical(codebook_view(), texts_view(), row_shares=[1.3, 1])
    return blueprint([seen, plane, beside], [1, 1.7, 1], frames_per_second)
