"""Layouts of recordings that show several estimates per frame: of methods, modes, particles."""

from __future__ import annotations

from collections.abc import Sequence

import rerun.blueprint as rrb

from silpose.recording import entity_paths
from silpose.recording.layout.views import (
    FROM_THE_SIDE,
    bars_view,
    blueprint,
    bodies_view,
    errors_view,
    figure_view,
    from_the_front,
    mask_view,
    series_view,
    state_view,
    texts_view,
)


def tracking_layout(
    methods: Sequence[str], frames_per_second: float, metric: str, masks: bool
) -> rrb.Blueprint:
    """Lay out several methods' estimates side by side, and a tracker's state below.

    Parameters
    ----------
    methods : sequence of str
        From left to right; the last is the tracker.
    frames_per_second : float
    metric : str
        Name of the errors.
    masks : bool
        Whether masks are recorded.
    """
    tracks = [entity_paths.below(entity_paths.TRACKS, method) for method in methods]
    estimates = rrb.Vertical(
        bodies_view(
            "true (blue) and estimated poses",
            [
                entity_paths.TRUE_SKELETON,
                entity_paths.TRACK_NAMES,
                *(f"{track}/skeleton" for track in tracks),
            ],
            from_the_front(0.75 * len(methods) + 0.5),
        ),
        state_view(),
        series_view("heading, degrees", [entity_paths.TRUE_HEADING, f"{tracks[-1]}/heading"]),
        errors_view(metric, ("ridge", "tracker")),
        row_shares=[3.2, 0.5, 1, 1],
    )
    belief = bars_view(entity_paths.BELIEF, "tracking: belief, by heading in degrees")
    seen = (
        rrb.Vertical(mask_view("silhouette: mask"), belief, row_shares=[1.5, 1])
        if masks
        else rrb.Vertical(belief)
    )
    return blueprint([seen, estimates, texts_view()], [1, 2.6, 1.1], frames_per_second)


def modes_layout(
    count: int, shown: Sequence[str], frames_per_second: float, metric: str, masks: bool
) -> rrb.Blueprint:
    """Lay out several modes per silhouette, and how probable each is.

    Parameters
    ----------
    count : int
        Number of modes.
    shown : sequence of str
        Methods whose errors are drawn.
    frames_per_second : float
    metric : str
        Name of the errors.
    masks : bool
        Whether masks are recorded.
    """
    modes = _numbered(entity_paths.MODES, count)
    headings = [entity_paths.TRUE_HEADING, *(f"{mode}/heading" for mode in modes[:2])]
    estimates = rrb.Vertical(
        bodies_view(
            "true pose (blue) and several estimates: the brighter, the more probable",
            [entity_paths.TRUE_SKELETON, *(f"{mode}/skeleton" for mode in modes)],
            FROM_THE_SIDE,
        ),
        series_view("probability of each mode", [f"{mode}/weight" for mode in modes], (0.0, 1.0)),
        series_view("heading, degrees", headings),
        errors_view(metric, shown),
        row_shares=[3.2, 0.9, 1, 1],
    )
    if not masks:
        return blueprint([estimates, texts_view()], [2.6, 1], frames_per_second)
    mask = mask_view("silhouette: mask")
    return blueprint([mask, estimates, texts_view()], [1, 2, 1], frames_per_second)


def hypotheses_layout(count: int, frames_per_second: float, masks: bool) -> rrb.Blueprint:
    """Lay out the modes of one silhouette beside those of a tracker's particles.

    Parameters
    ----------
    count : int
        Number of modes.
    frames_per_second : float
    masks : bool
        Whether masks are recorded.
    """
    alone = _numbered(entity_paths.MODES, count)
    tracked = _numbered(entity_paths.HYPOTHESES, count)
    bodies = rrb.Horizontal(
        *(
            bodies_view(
                title,
                [entity_paths.TRUE_SKELETON, *(f"{mode}/skeleton" for mode in modes)],
                FROM_THE_SIDE,
            )
            for title, modes in (
                ("this silhouette alone: mixture (true pose blue)", alone),
                ("all silhouettes so far: hypotheses (true pose blue)", tracked),
            )
        )
    )
    weights = rrb.Horizontal(
        series_view("probability: mixture", [f"{mode}/weight" for mode in alone], (0.0, 1.0)),
        series_view("probability: hypotheses", [f"{mode}/weight" for mode in tracked], (0.0, 1.0)),
    )
    headings = [
        entity_paths.TRUE_HEADING,
        f"{alone[0]}/heading",
        f"{entity_paths.below(entity_paths.TRACKS, 'hypotheses')}/heading",
    ]
    estimates = rrb.Vertical(
        bodies,
        weights,
        state_view(),
        series_view("heading, degrees: true, mode 1 of the mixture, tracker", headings),
        row_shares=[3, 0.9, 0.5, 1.1],
    )
    if not masks:
        return blueprint([estimates, texts_view()], [2.6, 1], frames_per_second)
    beside = rrb.Vertical(mask_view("silhouette"), texts_view(), row_shares=[1, 1.6])
    return blueprint([beside, estimates], [1, 2.8], frames_per_second)


def extinction_layout(trackers: Sequence[str], frames_per_second: float) -> rrb.Blueprint:
    """Lay out kernels that stop firing, and the error of the track that results.

    Parameters
    ----------
    trackers : sequence of str
    frames_per_second : float
    """
    kernels = [
        bars_view(
            entity_paths.below(entity_paths.KERNELS, tracker),
            f"activation of the kernels: {tracker}",
        )
        for tracker in trackers
    ]
    shown = rrb.Vertical(
        figure_view(),
        rrb.Horizontal(*kernels),
        series_view("error", [f"{entity_paths.ERROR}/**"]),
        row_shares=[2.2, 1, 1],
    )
    return blueprint([shown, texts_view()], [2.4, 1], frames_per_second)


def _numbered(root: str, count: int) -> list[str]:
    return [entity_paths.below(root, str(k + 1)) for k in range(count)]
