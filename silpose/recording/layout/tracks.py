"""Layouts of recordings that show several estimates per frame: of methods, modes, particles."""

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
    bars_view,
    blueprint,
    bodies_view,
    errors_view,
    figure_view,
    from_the_front,
    headings_view,
    mask_view,
    series_view,
    state_view,
    texts_view,
)


def tracking_layout(
    methods: Sequence[str],
    frames_per_second: float,
    metric: str,
    errors: Mapping[str, Array],
    masks: bool,
    window: Window | None = None,
) -> rrb.Blueprint:
    """Lay out several methods' estimates side by side, and a tracker's state below.

    Parameters
    ----------
    methods : sequence of str
        From left to right; the last is the tracker.
    frames_per_second : float
    metric : str
        Name of the errors.
    errors : mapping of str to ndarray, shape (F,)
        By method.
    masks : bool
        Whether masks are recorded.
    window : tuple of float, optional
        Part of the masks that is shown.
    """
    tracks = [entity_paths.below(entity_paths.TRACKS, method) for method in methods]
    estimates = rrb.Vertical(
        bodies_view(
            f"{coloured({'true': palette.TRUE})} and estimated poses",
            [
                entity_paths.TRUE_SKELETON,
                entity_paths.TRACK_NAMES,
                *(f"{track}/skeleton" for track in tracks),
            ],
            from_the_front(0.55 * len(methods) + 0.6),
        ),
        state_view(),
        headings_view(
            [entity_paths.TRUE_HEADING, f"{tracks[-1]}/heading"],
            {"true": palette.TRUE, methods[-1]: palette.of_method(methods[-1], 0, 1)},
        ),
        errors_view(metric, errors, ("ridge", "tracker")),
        row_shares=[3.2, 1, 1, 1],
    )
    belief = bars_view(entity_paths.BELIEF, "belief, by heading")
    seen = rrb.Vertical(*([mask_view(window=window)] if masks else []), belief)
    return blueprint([seen, estimates, texts_view()], [0.9, 2.45, 1.15], frames_per_second)


def modes_layout(
    count: int,
    frames_per_second: float,
    metric: str,
    errors: Mapping[str, Array],
    masks: bool,
    window: Window | None = None,
) -> rrb.Blueprint:
    """Lay out several modes per silhouette, and how probable each is.

    Parameters
    ----------
    count : int
        Number of modes.
    frames_per_second : float
    metric : str
        Name of the errors.
    errors : mapping of str to ndarray, shape (F,)
        By method.
    masks : bool
        Whether masks are recorded.
    window : tuple of float, optional
        Part of the masks that is shown.
    """
    modes = _numbered(entity_paths.MODES, count)
    colours = {str(k + 1): palette.one_of(k, count) for k in range(count)}
    headings = [entity_paths.TRUE_HEADING, *(f"{mode}/heading" for mode in modes[:2])]
    estimates = rrb.Vertical(
        bodies_view(
            f"{coloured({'true': palette.TRUE})} pose and modes: {coloured(colours)}; "
            "the less probable, the thinner",
            [entity_paths.TRUE_SKELETON, *(f"{mode}/skeleton" for mode in modes)],
            FROM_THE_SIDE,
        ),
        series_view("probability of each mode", [f"{mode}/weight" for mode in modes], UNIT_SPAN),
        headings_view(headings, {"true": palette.TRUE} | dict([*colours.items()][:2])),
        errors_view(metric, errors, list(errors)),
        row_shares=[2.9, 1, 1, 1.1],
    )
    if not masks:
        return blueprint([estimates, texts_view()], [2.6, 1], frames_per_second)
    mask = mask_view(window=window)
    return blueprint([mask, estimates, texts_view()], [0.75, 1.9, 1.3], frames_per_second)


def hypotheses_layout(
    count: int, frames_per_second: float, masks: bool, window: Window | None = None
) -> rrb.Blueprint:
    """Lay out the modes of one silhouette beside those of a tracker's particles.

    Parameters
    ----------
    count : int
        Number of modes.
    frames_per_second : float
    masks : bool
        Whether masks are recorded.
    window : tuple of float, optional
        Part of the masks that is shown.
    """
    alone = _numbered(entity_paths.MODES, count)
    tracked = _numbered(entity_paths.HYPOTHESES, count)
    colours = coloured({str(k + 1): palette.one_of(k, count) for k in range(count)})
    bodies = [
        bodies_view(
            f"{title}; {coloured({'true': palette.TRUE})}",
            [entity_paths.TRUE_SKELETON, *(f"{mode}/skeleton" for mode in modes)],
            FROM_THE_SIDE,
        )
        for title, modes in (("this mask alone", alone), ("all masks so far", tracked))
    ]
    seen = [mask_view(window=window)] if masks else []
    weights = [
        series_view(f"probability: {colours}", [f"{mode}/weight" for mode in modes], UNIT_SPAN)
        for modes in (alone, tracked)
    ]
    headings = [
        entity_paths.TRUE_HEADING,
        f"{alone[0]}/heading",
        f"{entity_paths.below(entity_paths.TRACKS, 'hypotheses')}/heading",
    ]
    estimates = rrb.Vertical(
        rrb.Horizontal(*seen, *bodies, column_shares=[*(0.7 for _ in seen), 1, 1]),
        rrb.Horizontal(*weights),
        state_view([entity_paths.SEEN, entity_paths.STATE]),
        headings_view(
            headings,
            {"true": palette.TRUE, "mode 1": palette.MODES[0], "tracker": palette.ESTIMATED},
        ),
        row_shares=[2.8, 0.9, 1.4, 1.1],
    )
    return blueprint([estimates, texts_view()], [2.1, 1], frames_per_second)


def extinction_layout(trackers: Sequence[str], frames_per_second: float) -> rrb.Blueprint:
    """Lay out kernels that stop firing, and the error of the track that results.

    Parameters
    ----------
    trackers : sequence of str
    frames_per_second : float
    """
    colours = {name: palette.one_of(k, len(trackers)) for k, name in enumerate(trackers)}
    kernels = [
        bars_view(
            entity_paths.below(entity_paths.KERNELS, tracker),
            f"active kernels (none while poses are given): {tracker}",
        )
        for tracker in trackers
    ]
    shown = rrb.Vertical(
        figure_view(),
        rrb.Horizontal(*kernels),
        series_view(
            f"error: {coloured(colours)}",
            [entity_paths.below(entity_paths.ERROR, tracker) for tracker in trackers],
        ),
        row_shares=[2.2, 1, 1],
    )
    return blueprint([shown, texts_view()], [1.7, 1], frames_per_second)


def _numbered(root: str, count: int) -> list[str]:
    return [entity_paths.below(root, str(k + 1)) for k in range(count)]
