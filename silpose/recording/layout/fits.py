"""Layout of recordings of a body that is fitted to masks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import rerun.blueprint as rrb

from silpose.core.types import Array
from silpose.recording import entity_paths, palette
from silpose.recording.captions import coloured
from silpose.recording.layout.views import (
    FROM_THE_SIDE,
    UNIT_SPAN,
    Window,
    blueprint,
    bodies_view,
    errors_view,
    from_the_front,
    series_view,
    texts_view,
)

_POSES = {
    "true": palette.TRUE,
    "before": palette.METHODS["ridge"],
    "fitted": palette.ESTIMATED,
}


def fitting_layout(
    shown: Sequence[str],
    frames_per_second: float,
    metric: str,
    errors: Mapping[str, Array],
    window: Window,
) -> rrb.Blueprint:
    """Lay out mask and fitted outline, the poses before and after, and one frame's iterations.

    Parameters
    ----------
    shown : sequence of str
        Methods whose errors and overlaps with the mask are drawn.
    frames_per_second : float
    metric : str
        Name of the errors.
    errors : mapping of str to ndarray, shape (F,)
        By method.
    window : tuple of float
        Part of the masks that is shown.
    """
    tabs = rrb.Tabs(_take(shown, metric, errors, window), _iterations(window), active_tab=0)
    return blueprint([tabs, texts_view()], [2.5, 1.15], frames_per_second)


def _take(
    shown: Sequence[str], metric: str, errors: Mapping[str, Array], window: Window
) -> rrb.Container:
    """Lay out the take, on the timelines `frame` and `time`."""
    overlap = rrb.Spatial2DView(
        origin=entity_paths.OVERLAP,
        name=coloured(palette.OVERLAP),
        visual_bounds=rrb.VisualBounds2D(x_range=window[:2], y_range=window[2:]),
    )
    bodies = bodies_view(
        f"{coloured(_POSES)}, and the fitted body",
        [
            entity_paths.TRUE_SKELETON,
            entity_paths.ESTIMATED_SKELETON,
            entity_paths.FITTED_SKELETON,
            f"{entity_paths.FITTED_BODY}/**",
        ],
        from_the_front(2.7),
    )
    colours = {m: palette.of_method(m, k, len(shown)) for k, m in enumerate(shown)}
    shares = [entity_paths.below(entity_paths.OVERLAP_SHARES, method) for method in shown]
    return rrb.Vertical(
        rrb.Horizontal(overlap, bodies, column_shares=[1, 1.6]),
        errors_view(metric, errors, shown),
        series_view(f"overlap of mask and body: {coloured(colours)}", shares, UNIT_SPAN),
        row_shares=[3.2, 1, 1],
        name="the take",
    )


def _iterations(window: Window) -> rrb.Container:
    """Lay out one frame, on the timeline `iteration`."""
    overlap = rrb.Spatial2DView(
        origin=entity_paths.ITERATED_OVERLAP,
        name="outline of this iteration; thin: of all",
        visual_bounds=rrb.VisualBounds2D(x_range=window[:2], y_range=window[2:]),
    )
    bodies = bodies_view(
        f"pose: {coloured({'true': palette.TRUE, 'of this iteration': palette.ESTIMATED})}",
        [entity_paths.ITERATED_TRUE_SKELETON, entity_paths.ITERATED_SKELETON],
        FROM_THE_SIDE,
    )
    return rrb.Vertical(
        rrb.Horizontal(overlap, bodies),
        rrb.Horizontal(
            series_view("cost: minus twice the log posterior", [entity_paths.ITERATED_COST]),
            series_view("overlap of mask and body", [entity_paths.ITERATED_IOU], UNIT_SPAN),
        ),
        row_shares=[3, 1],
        name="one frame converges (choose the timeline iteration)",
    )
