"""Layouts of recordings that show one estimate per frame."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import rerun.blueprint as rrb

from silpose.core.types import Array
from silpose.recording import entity_paths, palette
from silpose.recording.captions import coloured, in_words
from silpose.recording.layout.views import (
    FROM_THE_SIDE,
    JUDGED,
    TRUTH_AND_ESTIMATE,
    Window,
    blueprint,
    bodies_view,
    confidence_view,
    errors_view,
    estimate_input_view,
    from_the_front,
    heading_norm_view,
    headings_view,
    series_view,
    state_view,
    texts_view,
)


def single_image_layout(
    shown: Sequence[str],
    frames_per_second: float,
    metric: str,
    errors: Mapping[str, Array],
    window: Window | None = None,
    examples: bool = False,
) -> rrb.Blueprint:
    """Lay out the input of a single-image regressor, its estimate and its error.

    Parameters
    ----------
    shown : sequence of str
        Methods whose errors are drawn.
    frames_per_second : float
    metric : str
        Name of the errors.
    errors : mapping of str to ndarray, shape (F,)
        By method.
    window : tuple of float or None, default=None
        Part of the masks that is shown; None if there are no masks.
    examples : bool, default=False
        Whether influential examples are recorded.
    """
    estimate = rrb.Vertical(
        bodies_view(
            f"{coloured(TRUTH_AND_ESTIMATE)} pose; left side light, right side dark",
            [entity_paths.TRUE_SKELETON, entity_paths.ESTIMATED_SKELETON],
            FROM_THE_SIDE,
        ),
        headings_view(
            [entity_paths.TRUE_HEADING, entity_paths.ESTIMATED_HEADING], TRUTH_AND_ESTIMATE
        ),
        heading_norm_view(),
        errors_view(metric, errors, shown, shown[0]),
        row_shares=[3.4, 1, 0.7, 1],
    )
    columns = [estimate_input_view(window), estimate, texts_view(examples)]
    return blueprint(columns, [1.25, 1.7, 1.04], frames_per_second)


def prediction_layout(frames_per_second: float, window: Window, judged: bool) -> rrb.Blueprint:
    """Lay out poses estimated from masks, without ground truth; with confidence if `judged`."""
    bodies = bodies_view(
        f"{coloured(JUDGED)} pose; left side light, right side dark",
        [entity_paths.ESTIMATED_SKELETON],
        FROM_THE_SIDE,
    )
    heading = headings_view([entity_paths.ESTIMATED_HEADING], {"estimated": palette.ESTIMATED})
    certainty = confidence_view() if judged else heading_norm_view()
    estimate = rrb.Vertical(bodies, state_view(), heading, certainty, row_shares=[3.2, 1, 1, 0.8])
    inputs = estimate_input_view(window)
    return blueprint([inputs, estimate, texts_view()], [1.3, 1.7, 0.6], frames_per_second)


def comparison_layout(
    drawn: Mapping[str, str], frames_per_second: float, side_by_side: bool
) -> rrb.Blueprint:
    """Lay out runs side by side, and the error of one method of each in one plot.

    Parameters
    ----------
    drawn : mapping of str to str
        From a run's name to the method whose errors are drawn.
    frames_per_second : float
    side_by_side : bool
        Whether each run has several bodies beside one another.
    """
    bodies = (
        entity_paths.TRUE_SKELETON,
        entity_paths.ESTIMATED_SKELETON,
        entity_paths.FITTED_SKELETON,
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
    errors = [
        f"/{run}{entity_paths.below(entity_paths.ERROR, method)}" for run, method in drawn.items()
    ]
    colours = {
        f"{run}, {in_words(method)}": palette.one_of(k, len(drawn))
        for k, (run, method) in enumerate(drawn.items())
    }
    shown = rrb.Vertical(
        rrb.Grid(*views, grid_columns=1 if side_by_side else min(len(views), 3)),
        series_view(f"error: {coloured(colours)}", errors),
        row_shares=[3 if side_by_side else 2, 1],
    )
    results = rrb.TextDocumentView(origin=entity_paths.METRICS, name="results")
    return blueprint([shown, results], [2.4, 1], frames_per_second)
