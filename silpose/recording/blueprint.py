"""Layouts of the viewer, one per kind of recording."""

from __future__ import annotations

from collections.abc import Sequence

import rerun as rr
import rerun.blueprint as rrb

from silpose.recording import entities

_GROUND = rrb.LineGrid3D(spacing=0.5, plane=rr.components.Plane3D([0, 1, 0], 0), color=[70, 72, 80])


def single_image(
    shown: Sequence[str],
    frames_per_second: float,
    metric: str,
    masks: bool = True,
    reasons: bool = False,
) -> rrb.Blueprint:
    """Lay out what a single-image regressor sees, answers, and how far off it is.

    Parameters
    ----------
    shown : sequence of str
        Methods whose errors are drawn.
    frames_per_second : float
    metric : str
        Of the errors.
    masks, reasons : bool
        Whether there are any to show.
    """
    answered = rrb.Vertical(
        _body_view("true (blue) and estimated (orange) pose; left side light, right side dark"),
        _series("heading, degrees", [entities.TRUE_HEADING, entities.ESTIMATED_HEADING]),
        _series(
            "heading norm: drops where the estimate doubts", [entities.HEADING_NORM], (0.0, 1.3)
        ),
        _series(metric.replace("_", " "), [f"{entities.ERROR}/{m}" for m in shown]),
        row_shares=[3.4, 1, 0.7, 1],
    )
    return _layout([_seen(masks), answered, _texts(reasons)], [1, 1.9, 1], frames_per_second)


def predict(frames_per_second: float) -> rrb.Blueprint:
    """Lay out poses estimated from masks whose truth nobody knows."""
    answered = rrb.Vertical(
        _body_view("estimated pose; left side light, right side dark"),
        _series("heading, degrees", [entities.ESTIMATED_HEADING]),
        _series(
            "heading norm: drops where the estimate doubts", [entities.HEADING_NORM], (0.0, 1.3)
        ),
        row_shares=[3.4, 1, 0.7],
    )
    return _layout([_seen(), answered, _texts()], [1, 1.9, 0.8], frames_per_second)


def tracking(
    methods: Sequence[str], frames_per_second: float, metric: str, masks: bool
) -> rrb.Blueprint:
    """Lay out several methods' estimates side by side, and a tracker's state below."""
    width = 0.75 * len(methods) + 0.3
    headings = [entities.TRUE_HEADING, *(f"{entities.TRACKS}/{m}/heading" for m in methods[-1:])]
    answered = rrb.Vertical(
        rrb.Spatial3DView(
            origin="/",
            contents=[
                entities.TRUE_SKELETON,
                entities.TRACK_NAMES,
                *(f"{entities.TRACKS}/{method}/skeleton" for method in methods),
            ],
            name="true (blue) and estimated poses",
            background=[22, 24, 28],
            line_grid=_GROUND,
            eye_controls=rrb.EyeControls3D(
                kind=rrb.Eye3DKind.Orbital,
                position=[0.0, 1.2, width],
                look_target=[0.0, 0.95, 0.0],
                eye_up=[0, 1, 0],
            ),
        ),
        rrb.StateTimelineView(origin=entities.STATE, name="state of the tracker"),
        _series("heading, degrees", headings),
        _series(metric.replace("_", " "), [f"{entities.ERROR}/{m}" for m in ("ridge", "tracker")]),
        row_shares=[3.2, 0.5, 1, 1],
    )
    belief = _bars(entities.BELIEF, "tracking: belief over key poses")
    mask = rrb.Spatial2DView(
        origin=entities.CAMERA, contents=[entities.MASK], name="silhouette: mask"
    )
    seen = rrb.Vertical(mask, belief, row_shares=[1.5, 1]) if masks else rrb.Vertical(belief)
    return _layout([seen, answered, _texts()], [1, 2.6, 1.1], frames_per_second)


def modes(
    count: int, shown: Sequence[str], frames_per_second: float, metric: str, masks: bool
) -> rrb.Blueprint:
    """Lay out several answers to each silhouette, and how probable each is."""
    each = [f"{entities.MODES}/{k + 1}" for k in range(count)]
    answered = rrb.Vertical(
        _body_view(
            "true pose (blue) and several estimates: the brighter, the more probable",
            [entities.TRUE_SKELETON, *(f"{mode}/skeleton" for mode in each)],
        ),
        _series("probability of each mode", [f"{mode}/weight" for mode in each], (0.0, 1.0)),
        _series("heading, degrees", [entities.TRUE_HEADING, *(f"{m}/heading" for m in each[:2])]),
        _series(metric.replace("_", " "), [f"{entities.ERROR}/{m}" for m in shown]),
        row_shares=[3.2, 0.9, 1, 1],
    )
    if not masks:
        return _layout([answered, _texts()], [2.6, 1], frames_per_second)
    mask = rrb.Spatial2DView(
        origin=entities.CAMERA, contents=[entities.MASK], name="silhouette: mask"
    )
    return _layout([mask, answered, _texts()], [1, 2, 1], frames_per_second)


def extinction(trackers: Sequence[str], frames_per_second: float) -> rrb.Blueprint:
    """Lay out kernels that stop firing, and what becomes of the track."""
    kernels = [
        _bars(f"{entities.KERNELS}/{t}", f"activation of the kernels: {t}") for t in trackers
    ]
    shown = rrb.Vertical(
        rrb.Spatial2DView(origin=entities.FIGURE, name="figure"),
        rrb.Horizontal(*kernels),
        _series("error", [f"{entities.ERROR}/**"]),
        row_shares=[2.2, 1, 1],
    )
    return _layout([shown, _texts()], [2.4, 1], frames_per_second)


def study(title: str, frames_per_second: float) -> rrb.Blueprint:
    """Lay out a figure, and the errors behind it over time."""
    shown = rrb.Vertical(
        rrb.Spatial2DView(origin=entities.FIGURE, name="figure"),
        _series(title, [f"{entities.ERROR}/**"]),
        row_shares=[1.6, 1],
    )
    return _layout([shown, _texts()], [2.4, 1], frames_per_second)


def bridges() -> rrb.Blueprint:
    """Lay out how the columns of an RVM vanish; a frame is an iteration."""
    shown = rrb.Vertical(
        rrb.Spatial2DView(origin=entities.FIGURE, name="figure"),
        _bars(entities.COLUMN_NORMS, "regression: size of every basis function's column"),
        rrb.Horizontal(
            _series("columns left", [entities.COLUMNS_LEFT]),
            _series("objective (Eq. 5) of the columns left", [entities.OBJECTIVE]),
        ),
        row_shares=[1.6, 1, 0.8],
    )
    return _layout([shown, _texts()], [2.4, 1], 2.0)


def features(parts: Sequence[str], frames_per_second: float) -> rrb.Blueprint:
    """Lay out one picture per body part: the silhouette and the points that tell its pose."""
    views = [
        rrb.Spatial2DView(
            origin=entities.CAMERA,
            contents=[entities.MASK, f"{entities.FEATURES}/{part}"],
            name=part.replace("_", " "),
        )
        for part in parts
    ]
    return _layout([rrb.Grid(*views, grid_columns=3), _texts()], [2.6, 1], frames_per_second)


def _layout(
    columns: Sequence[rrb.Container | rrb.View], shares: Sequence[float], frames_per_second: float
) -> rrb.Blueprint:
    return rrb.Blueprint(
        rrb.Horizontal(*columns, column_shares=shares),
        rrb.BlueprintPanel(state="collapsed"),
        rrb.SelectionPanel(state="collapsed"),
        rrb.TimePanel(
            state="collapsed", timeline="frame", fps=frames_per_second, play_state="paused"
        ),
        auto_layout=False,
        auto_views=False,
    )


def _seen(masks: bool = True) -> rrb.Container:
    bars = [
        _bars(entities.HISTOGRAM, "descriptor: histogram of shape contexts"),
        _bars(entities.ACTIVATIONS, "regression: activation of each relevance vector"),
    ]
    if not masks:
        return rrb.Vertical(*bars)
    return rrb.Vertical(_mask_view(), *bars, row_shares=[2.2, 1, 1])


def _mask_view() -> rrb.Spatial2DView:
    return rrb.Spatial2DView(
        origin=entities.CAMERA,
        contents=[entities.MASK, entities.EDGE_POINTS],
        name="silhouette: mask and edge points",
    )


def _body_view(
    name: str,
    contents: Sequence[str] = (entities.TRUE_SKELETON, entities.ESTIMATED_SKELETON),
) -> rrb.Spatial3DView:
    return rrb.Spatial3DView(
        origin="/",
        contents=list(contents),
        name=name,
        background=[22, 24, 28],
        line_grid=_GROUND,
        eye_controls=rrb.EyeControls3D(
            kind=rrb.Eye3DKind.Orbital,
            position=[0.95, 1.15, 2.0],
            look_target=[0.0, 0.85, 0.0],
            eye_up=[0, 1, 0],
        ),
    )


def _bars(entity: str, name: str) -> rrb.BarChartView:
    return rrb.BarChartView(origin=entity, name=name, plot_legend=rrb.PlotLegend(visible=False))


def _series(
    name: str, contents: Sequence[str], span: tuple[float, float] | None = None
) -> rrb.TimeSeriesView:
    return rrb.TimeSeriesView(
        origin="/",
        contents=list(contents),
        name=name,
        plot_legend=rrb.Corner2D.LeftTop,
        axis_y=rrb.ScalarAxis(range=span) if span else None,
    )


def _texts(reasons: bool = False) -> rrb.Container:
    texts = [
        rrb.TextDocumentView(origin=entities.METRICS, name="results"),
        rrb.TextDocumentView(origin=entities.SETTINGS, name="settings"),
    ]
    if not reasons:
        return rrb.Vertical(*texts, row_shares=[1, 1.3])
    why = rrb.Spatial2DView(
        origin=entities.REASONS, name="why this pose? training examples and their weight"
    )
    return rrb.Vertical(texts[0], why, texts[1], row_shares=[1, 1, 0.6])
