"""Views that layouts are made of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import rerun as rr
import rerun.blueprint as rrb

from silpose.core.types import Array
from silpose.recording import entity_paths, palette
from silpose.recording.captions import coloured, in_words

Window = tuple[float, float, float, float]
"""Left, right, top and bottom of what an image view shows, pixels."""

UNIT_SPAN = (0.0, 1.05)
"""Of probabilities and other shares: a little more, so that 1 is seen."""

JUDGED = {"estimated": palette.ESTIMATED, "doubtful": palette.DOUBTFUL}
TRUTH_AND_ESTIMATE = {"true": palette.TRUE, "estimated": palette.ESTIMATED}

GROUND = rrb.LineGrid3D(
    spacing=0.5, plane=rr.components.Plane3D([0, 1, 0], 0), color=[*palette.NEUTRAL, 90]
)

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


def of_the_box(low: Sequence[float], high: Sequence[float]) -> rrb.EyeControls3D:
    """Eye that sees all between two corners, metres, obliquely from its longer side."""
    middle, size = (np.array(high) + low) / 2, np.array(high) - low
    away = 0.5 + 0.55 * float(np.hypot(*size[[0, 2]])) + 0.5 * size[1]
    side = (0.9, 0.3, 0.45) if size[2] > size[0] else (0.45, 0.3, 0.9)
    return rrb.EyeControls3D(
        kind=rrb.Eye3DKind.Orbital,
        position=(middle + away * np.array(side)).tolist(),
        look_target=middle.tolist(),
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


def estimate_input_view(window: Window | None, title: str = "mask, edges, pose") -> rrb.Container:
    """Mask, codebook, histogram and activations; without a window the last two."""
    bars = [
        histogram_view(),
        bars_view(entity_paths.ACTIVATIONS, "regression: activation of each relevance vector"),
    ]
    if window is None:
        return rrb.Vertical(*bars)
    above = rrb.Horizontal(mask_view(title, window), codebook_view(), column_shares=[1.05, 1.15])
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


def mask_view(name: str = "mask and pose", window: Window | None = None) -> rrb.Spatial2DView:
    """Mask with its edge points, where there are any."""
    return rrb.Spatial2DView(
        origin=entity_paths.CAMERA,
        contents=[
            entity_paths.MASK,
            entity_paths.FRAME,
            entity_paths.EDGE_POINTS,
            entity_paths.OVERLAID_SKELETON,
        ],
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
        line_grid=GROUND,
        eye_controls=eye,
        overrides=overrides,
    )


def bars_view(entity: str, name: str) -> rrb.BarChartView:
    """Bar chart."""
    return rrb.BarChartView(origin=entity, name=name, plot_legend=rrb.PlotLegend(visible=False))


def series_view(
    name: str,
    contents: Sequence[str],
    span: tuple[float, float] | None = None,
) -> rrb.TimeSeriesView:
    """Numbers over time, the vertical axis of a given span where there is one.

    A legend would cover what is drawn: the title says which colour is what.
    """
    return rrb.TimeSeriesView(
        origin="/",
        contents=list(contents),
        name=name,
        plot_legend=rrb.PlotLegend(visible=False),
        axis_y=rrb.ScalarAxis(range=span) if span else None,
    )


def errors_view(
    metric: str,
    errors: Mapping[str, Array],
    methods: Sequence[str],
    estimated: str | None = None,
) -> rrb.TimeSeriesView:
    """Error of some methods over time; that of the estimate which is shown has its colour."""
    colours = {m: palette.of_method(m, k, len(methods)) for k, m in enumerate(methods)}
    if estimated is not None:
        colours[estimated] = palette.ESTIMATED
    entities = [entity_paths.below(entity_paths.ERROR, method) for method in methods]
    title = f"{in_words(metric)}: {coloured(colours)}"
    return series_view(title, entities, span_of([errors[m] for m in methods if m in errors]))


def span_of(errors: Sequence[Array]) -> tuple[float, float]:
    """From 0 to a round number above all errors, so that an axis has two ticks at least.

    The viewer writes powers of ten, and their multiples where these have room.
    """
    highest = max((float(np.nanmax(own)) for own in errors if np.isfinite(own).any()), default=0.0)
    if highest <= 0:
        return 0.0, 1.0
    tick = 10.0 ** np.ceil(np.log10(highest) - 0.5)  # 1 up to 3.2, 10 up to 32
    return 0.0, float(tick * np.ceil(highest / tick) * 1.08)


def headings_view(contents: Sequence[str], colours: Mapping[str, palette.Colour]) -> rrb.View:
    """Headings over time, which go once around."""
    return series_view(f"heading, degrees: {coloured(colours)}", contents, (-185.0, 185.0))


def heading_norm_view() -> rrb.TimeSeriesView:
    """Heading norm over time."""
    title = "heading norm: lower for uncertain estimates"
    return series_view(title, [entity_paths.HEADING_NORM], (0.0, 1.3))


def confidence_view() -> rrb.TimeSeriesView:
    """Confidence over time."""
    return series_view("confidence: below 0.5 is doubtful", [entity_paths.CONFIDENCE], (0.0, 1.05))


def state_view(contents: Sequence[str] = (entity_paths.STATE,)) -> rrb.StateTimelineView:
    """State of each frame as a lane."""
    return rrb.StateTimelineView(origin="/", contents=list(contents), name="state")


def texts_view(examples: bool = False) -> rrb.Container:
    """Results, and settings in a tab behind them; below, influential examples if there are any."""
    texts = rrb.Tabs(
        rrb.TextDocumentView(origin=entity_paths.METRICS, name="results"),
        rrb.TextDocumentView(origin=entity_paths.SETTINGS, name="settings"),
        active_tab=0,
    )
    if not examples:
        return texts
    influential = rrb.Spatial2DView(
        origin=entity_paths.INFLUENTIAL_EXAMPLES,
        name="why this pose? training examples by weight",
    )
    return rrb.Vertical(texts, influential, row_shares=[1.3, 1])
