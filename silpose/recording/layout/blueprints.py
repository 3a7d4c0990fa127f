"""Layouts of the viewer, one per kind of recording."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import rerun.blueprint as rrb

from silpose.recording import entity_paths
from silpose.recording.layout.views import (
    FROM_THE_SIDE,
    Window,
    bars_view,
    bodies_view,
    codebook_view,
    from_the_front,
    histogram_view,
    layout,
    mask_view,
    seen_view,
    series_view,
    state_view,
    texts_view,
)


def single_image(
    shown: Sequence[str],
    frames_per_second: float,
    metric: str,
    window: Window | None = None,
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
    window : Window or None
        Of the masks; None if there are no masks.
    reasons : bool
        Whether there are any to show.
    """
    answered = rrb.Vertical(
        bodies_view(
            "true (blue) and estimated (orange) pose; left side light, right side dark",
            [entity_paths.TRUE_SKELETON, entity_paths.ESTIMATED_SKELETON],
            FROM_THE_SIDE,
        ),
        series_view(
            "heading, degrees", [entity_paths.TRUE_HEADING, entity_paths.ESTIMATED_HEADING]
        ),
        series_view(
            "heading norm: drops where the estimate doubts", [entity_paths.HEADING_NORM], (0.0, 1.3)
        ),
        series_view(
            metric.replace("_", " "), [entity_paths.of(entity_paths.ERROR, m) for m in shown]
        ),
        row_shares=[3.4, 1, 0.7, 1],
    )
    return layout(
        [seen_view(window), answered, texts_view(reasons)], [1.3, 1.7, 1], frames_per_second
    )


def predict(frames_per_second: float, window: Window, tracked: bool) -> rrb.Blueprint:
    """Lay out poses estimated from masks whose truth nobody knows."""
    bodies = bodies_view(
        "estimated pose; left side light, right side dark",
        [entity_paths.ESTIMATED_SKELETON],
        FROM_THE_SIDE,
    )
    heading = series_view("heading, degrees", [entity_paths.ESTIMATED_HEADING])
    doubt = series_view(
        "heading norm: drops where the estimate doubts", [entity_paths.HEADING_NORM], (0.0, 1.3)
    )
    if tracked:
        answered = rrb.Vertical(bodies, state_view(), heading, doubt, row_shares=[3.4, 0.5, 1, 0.7])
    else:
        answered = rrb.Vertical(bodies, heading, doubt, row_shares=[3.4, 1, 0.7])
    return layout([seen_view(window), answered, texts_view()], [1.3, 1.7, 0.6], frames_per_second)


def tracking(
    methods: Sequence[str], frames_per_second: float, metric: str, masks: bool
) -> rrb.Blueprint:
    """Lay out several methods' estimates side by side, and a tracker's state below."""
    headings = [
        entity_paths.TRUE_HEADING,
        *(f"{entity_paths.of(entity_paths.TRACKS, m)}/heading" for m in methods[-1:]),
    ]
    answered = rrb.Vertical(
        bodies_view(
            "true (blue) and estimated poses",
            [
                entity_paths.TRUE_SKELETON,
                entity_paths.TRACK_NAMES,
                *(f"{entity_paths.of(entity_paths.TRACKS, method)}/skeleton" for method in methods),
            ],
            from_the_front(0.75 * len(methods) + 0.5),
        ),
        state_view(),
        series_view("heading, degrees", headings),
        series_view(
            metric.replace("_", " "),
            [entity_paths.of(entity_paths.ERROR, m) for m in ("ridge", "tracker")],
        ),
        row_shares=[3.2, 0.5, 1, 1],
    )
    belief = bars_view(entity_paths.BELIEF, "tracking: belief, by heading in degrees")
    mask = rrb.Spatial2DView(
        origin=entity_paths.CAMERA, contents=[entity_paths.MASK], name="silhouette: mask"
    )
    seen = rrb.Vertical(mask, belief, row_shares=[1.5, 1]) if masks else rrb.Vertical(belief)
    return layout([seen, answered, texts_view()], [1, 2.6, 1.1], frames_per_second)


def modes(
    count: int, shown: Sequence[str], frames_per_second: float, metric: str, masks: bool
) -> rrb.Blueprint:
    """Lay out several answers to each silhouette, and how probable each is."""
    each = [f"{entity_paths.MODES}/{k + 1}" for k in range(count)]
    answered = rrb.Vertical(
        bodies_view(
            "true pose (blue) and several estimates: the brighter, the more probable",
            [entity_paths.TRUE_SKELETON, *(f"{mode}/skeleton" for mode in each)],
            FROM_THE_SIDE,
        ),
        series_view("probability of each mode", [f"{mode}/weight" for mode in each], (0.0, 1.0)),
        series_view(
            "heading, degrees", [entity_paths.TRUE_HEADING, *(f"{m}/heading" for m in each[:2])]
        ),
        series_view(
            metric.replace("_", " "), [entity_paths.of(entity_paths.ERROR, m) for m in shown]
        ),
        row_shares=[3.2, 0.9, 1, 1],
    )
    if not masks:
        return layout([answered, texts_view()], [2.6, 1], frames_per_second)
    mask = rrb.Spatial2DView(
        origin=entity_paths.CAMERA, contents=[entity_paths.MASK], name="silhouette: mask"
    )
    return layout([mask, answered, texts_view()], [1, 2, 1], frames_per_second)


def hypotheses(count: int, frames_per_second: float, masks: bool) -> rrb.Blueprint:
    """Lay out what a silhouette says by itself beside what a tracker has made of all so far."""
    seen, held = (
        [f"{root}/{k + 1}" for k in range(count)]
        for root in (entity_paths.MODES, entity_paths.HYPOTHESES)
    )
    bodies = rrb.Horizontal(
        *(
            bodies_view(
                title,
                [entity_paths.TRUE_SKELETON, *(f"{mode}/skeleton" for mode in modes)],
                FROM_THE_SIDE,
            )
            for title, modes in (
                ("this silhouette alone: mixture (true pose blue)", seen),
                ("with its past: hypotheses (true pose blue)", held),
            )
        )
    )
    headings = [
        entity_paths.TRUE_HEADING,
        f"{seen[0]}/heading",
        f"{entity_paths.TRACKS}/hypotheses/heading",
    ]
    weights = rrb.Horizontal(
        series_view("probability: mixture", [f"{mode}/weight" for mode in seen], (0.0, 1.0)),
        series_view("probability: hypotheses", [f"{mode}/weight" for mode in held], (0.0, 1.0)),
    )
    answered = rrb.Vertical(
        bodies,
        weights,
        state_view(),
        series_view("heading, degrees: true, mode 1 of the mixture, tracker", headings),
        row_shares=[3, 0.9, 0.5, 1.1],
    )
    if not masks:
        return layout([answered, texts_view()], [2.6, 1], frames_per_second)
    told = rrb.Vertical(mask_view("silhouette"), texts_view(), row_shares=[1, 1.6])
    return layout([told, answered], [1, 2.8], frames_per_second)


def extinction(trackers: Sequence[str], frames_per_second: float) -> rrb.Blueprint:
    """Lay out kernels that stop firing, and what becomes of the track."""
    kernels = [
        bars_view(entity_paths.of(entity_paths.KERNELS, t), f"activation of the kernels: {t}")
        for t in trackers
    ]
    shown = rrb.Vertical(
        rrb.Spatial2DView(origin=entity_paths.FIGURE, name="figure"),
        rrb.Horizontal(*kernels),
        series_view("error", [f"{entity_paths.ERROR}/**"]),
        row_shares=[2.2, 1, 1],
    )
    return layout([shown, texts_view()], [2.4, 1], frames_per_second)


def comparison(
    drawn: Mapping[str, str], frames_per_second: float, side_by_side: bool
) -> rrb.Blueprint:
    """Lay out runs side by side, and the error of one method of each in one plot.

    Parameters
    ----------
    drawn : mapping of str to str
        From a run's name to the method whose errors are drawn.
    frames_per_second : float
    side_by_side : bool
        Whether each run has several bodies of its own.
    """
    bodies = (
        entity_paths.TRUE_SKELETON,
        entity_paths.ESTIMATED_SKELETON,
        entity_paths.TRACK_NAMES,
        f"{entity_paths.TRACKS}/**",
    )
    views = [
        bodies_view(
            run,
            [f"$origin{path}" for path in bodies],
            from_the_front(2.6 if side_by_side else 2.1),
            f"/{run}",
        )
        for run in drawn
    ]
    shown = rrb.Vertical(
        rrb.Grid(*views, grid_columns=1 if side_by_side else min(len(views), 3)),
        series_view(
            "error", [f"/{run}{entity_paths.ERROR}/{method}" for run, method in drawn.items()]
        ),
        row_shares=[3 if side_by_side else 2, 1],
    )
    results = rrb.TextDocumentView(origin=entity_paths.METRICS, name="results")
    return layout([shown, results], [2.4, 1], frames_per_second)


def study(title: str | None, frames_per_second: float, masks: bool = False) -> rrb.Blueprint:
    """Lay out a figure and, where they have a title, the errors behind it, beside the masks."""
    figure = rrb.Spatial2DView(origin=entity_paths.FIGURE, name="figure")
    if title is None:
        return layout([figure, texts_view()], [2.4, 1], frames_per_second)
    below: rrb.Container | rrb.View = series_view(title, [f"{entity_paths.ERROR}/**"])
    if masks:
        below = rrb.Horizontal(mask_view("silhouette"), below, column_shares=[1, 2.4])
    shown = rrb.Vertical(figure, below, row_shares=[1.6, 1])
    return layout([shown, texts_view()], [2.4, 1], frames_per_second)


def bridges() -> rrb.Blueprint:
    """Lay out how the columns of an RVM vanish; a frame is an iteration."""
    shown = rrb.Vertical(
        rrb.Spatial2DView(origin=entity_paths.FIGURE, name="figure"),
        bars_view(entity_paths.COLUMN_NORMS, "regression: size of every basis function's column"),
        rrb.Horizontal(
            series_view("columns left", [entity_paths.COLUMNS_LEFT]),
            series_view("objective (Eq. 5) of the columns left", [entity_paths.OBJECTIVE]),
        ),
        row_shares=[1.6, 1, 0.8],
    )
    return layout([shown, texts_view()], [2.4, 1], 2.0)


def features(parts: Sequence[str], frames_per_second: float) -> rrb.Blueprint:
    """Lay out one picture per body part: the silhouette and the points that tell its pose."""
    views = [
        rrb.Spatial2DView(
            origin=entity_paths.CAMERA,
            contents=[entity_paths.MASK, f"{entity_paths.FEATURES}/{part}"],
            name=part.replace("_", " "),
        )
        for part in parts
    ]
    return layout([rrb.Grid(*views, grid_columns=3), texts_view()], [2.6, 1], frames_per_second)


def space(frames_per_second: float) -> rrb.Blueprint:
    """Lay out a silhouette, where its edge points are among all contexts, and the codebook."""
    plane = rrb.Spatial2DView(
        origin=entity_paths.SPACE, name="shape contexts: all (grey), centres, this silhouette's"
    )
    seen = rrb.Vertical(mask_view(), histogram_view(), row_shares=[2.2, 1])
    told = rrb.Vertical(codebook_view(), texts_view(), row_shares=[1.3, 1])
    return layout([seen, plane, told], [1, 1.7, 1], frames_per_second)
