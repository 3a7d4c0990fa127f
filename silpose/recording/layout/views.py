"""Views that layouts are made of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import rerun as rr
import rerun.blueprint as rrb

from silpose.recording import entity_paths

Window = tuple[float, float, float, float]
"""Left, right, top and bottom of what an image view shows, pixels."""

GROUND = rrb.LineGrid3D(spacing=0.5, plane=rr.components.Plane3D([0, 1, 0], 0), color=[70, 72, 80])

FROM_THE_SIDE = rrb.EyeControls3D(
    kind=rrb.Eye3DKind.Orbital,
    position=[0.95, 1.15, 2.0],
    look_target=[0.0, 0.85, 0.0],
    eye_up=[0, 1, 0],
)


def from_the_front(away: float) -> rrb.EyeControls3D:
    """Eye that looks at the origin from so many metres away."""
    return rrb.EyeControls3D(
        kind=rrb.Eye3DKind.Orbital,
        position=[0.0, 1.2, away],
        look_target=[0.0, 0.95, 0.0],
        eye_up=[0, 1, 0],
    )


def blueprint(
    columns: Sequence[rrb.Container | rrb.View],
    shares: Sequence[float],
    frames_per_second: float,
    follow: bool = False,
) -> rrb.Blueprint:
    """Columns of views above a collapsed timeline, which may go on with what arrives."""
    return rrb.Blueprint(
        rrb.Horizontal(*columns, column_shares=shares),
        rrb.BlueprintPanel(state="collapsed"),
        rrb.SelectionPanel(state="collapsed"),
        rrb.TimePanel(
            state="collapsed",
            timeline="frame",
            fps=frames_per_second,
            play_state="following" if follow else "paused",
        ),
        auto_layout=False,
        auto_views=False,
    )


def hide(part: rrb.Container | rrb.View, origin: str) -> None:
    """Hide the views of an entity to which nothing is logged, so that others get their space."""
    if isinstance(part, rrb.Container):
        for inner in part.contents:
            hide(inner, origin)
    elif part.origin == origin:
        part.visible = False


def estimate_input_view(
    window: Window | None, title: str = "mask and edge points"
) -> rrb.Container:
    """Mask, codebook, histogram and activations; without a window the last two."""
    bars = [
        histogram_view(),
        bars_view(entity_paths.ACTIVATIONS, "regression: activation of each relevance vector"),
    ]
    if window is None:
        return rrb.Vertical(*bars)
    above = rrb.Horizontal(mask_view(title, window), codebook_view(), column_shares=[1, 1.2])
    return rrb.Vertical(above, *bars, row_shares=[1.8, 1, 1])


def histogram_view() -> rrb.BarChartView:
    """Histogram of shape contexts as bars."""
    return bars_view(entity_paths.HISTOGRAM, "descriptor: % of votes for each centre")


def codebook_view() -> rrb.Spatial2DView:
    """Image of the codebook."""
    return rrb.Spatial2DView(origin=entity_paths.CODEBOOK, name="codebook, votes as bars")


def figure_view() -> rrb.Spatial2DView:
    """Figure of the experiment."""
    return rrb.Spatial2DView(origin=entity_paths.FIGURE, name="figure")


def mask_view(
    name: str = "mask, edge points by nearest centre", window: Window | None = None
) -> rrb.Spatial2DView:
    """Mask with its edge points, where there are any."""
    return rrb.Spatial2DView(
        origin=entity_paths.CAMERA,
        contents=[entity_paths.MASK, entity_paths.EDGE_POINTS, entity_paths.OVERLAID_SKELETON],
        name=name,
        visual_bounds=rrb.VisualBounds2D(x_range=window[:2], y_range=window[2:])
        if window
        else None,
    )


def bodies_view(
    name: str,
    contents: Sequence[str],
    eye: rrb.EyeControls3D,
    origin: str = "/",
    overrides: Mapping[Any, Any] | None = None,
) -> rrb.Spatial3DView:
    """Skeletons on the ground; entities may be shown in a way of their own."""
    return rrb.Spatial3DView(
        origin=origin,
        contents=list(contents),
        name=name,
        background=[22, 24, 28],
        line_grid=GROUND,
        eye_controls=eye,
        overrides=overrides,
    )


def bars_view(entity: str, name: str) -> rrb.BarChartView:
    """Bar chart."""
    return rrb.BarChartView(origin=entity, name=name, plot_legend=rrb.PlotLegend(visible=False))


def series_view(
    name: str, contents: Sequence[str], span: tuple[float, float] | None = None
) -> rrb.TimeSeriesView:
    """Numbers over time, the vertical axis of a given span where there is one."""
    return rrb.TimeSeriesView(
        origin="/",
        contents=list(contents),
        name=name,
        plot_legend=rrb.Corner2D.LeftTop,
        axis_y=rrb.ScalarAxis(range=span) if span else None,
    )


def errors_view(metric: str, methods: Sequence[str]) -> rrb.TimeSeriesView:
    """Error of some methods over time."""
    entities = [entity_paths.below(entity_paths.ERROR, method) for method in methods]
    return series_view(metric.replace("_", " "), entities)


def heading_norm_view() -> rrb.TimeSeriesView:
    """Heading norm over time."""
    title = "heading norm: lower for uncertain estimates"
    return series_view(title, [entity_paths.HEADING_NORM], (0.0, 1.3))


def confidence_view() -> rrb.TimeSeriesView:
    """Confidence over time."""
    return series_view("confidence: below 0.5 is doubtful", [entity_paths.CONFIDENCE], (0.0, 1.05))


def state_view() -> rrb.StateTimelineView:
    """State of each frame as a lane."""
    return rrb.StateTimelineView(origin=entity_paths.STATE, name="state")


def texts_view(examples: bool = False) -> rrb.Container:
    """Results and settings in words; between them influential examples, where there are any."""
    texts = [
        rrb.TextDocumentView(origin=entity_paths.METRICS, name="results"),
        rrb.TextDocumentView(origin=entity_paths.SETTINGS, name="settings"),
    ]
    if not examples:
        return rrb.Vertical(*texts, row_shares=[1, 1.3])
    influential = rrb.Spatial2DView(
        origin=entity_paths.INFLUENTIAL_EXAMPLES,
        name="influential training examples and their weights",
    )
    return rrb.Vertical(texts[0], influential, texts[1], row_shares=[1, 1, 0.6])
