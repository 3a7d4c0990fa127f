"""Layout of recordings of films and cameras."""

from __future__ import annotations

import rerun.blueprint as rrb

from silpose.recording import entity_paths, palette
from silpose.recording.captions import coloured
from silpose.recording.layout.views import (
    blueprint,
    bodies_view,
    series_view,
    texts_view,
)

_DRAWN = {
    "outline": palette.EDGE,
    "skeleton": palette.ESTIMATED,
    "where doubtful": palette.DOUBTFUL,
}
_SURE = {"overlap": palette.ESTIMATED, "confidence": palette.NEUTRAL}
_SO_FAR = rrb.VisibleTimeRanges(
    timeline="frame",
    start=rrb.TimeRangeBoundary.infinite(),
    end=rrb.TimeRangeBoundary.cursor_relative(),
)


def video_layout(
    frames_per_second: float, size: tuple[int, ...], live: bool = False
) -> rrb.Blueprint:
    """Lay out the picture and the bodies, and below them the gait and how sure it is.

    Parameters
    ----------
    frames_per_second : float
    size : tuple of int
        Height and width of the pictures, pixels.
    live : bool, default=False
        Whether the view goes on with what arrives, and shows how late that is.
    """
    height, width = size
    picture = rrb.Spatial2DView(
        origin=entity_paths.CAMERA,
        contents=[
            entity_paths.PICTURE,
            entity_paths.MASK,
            entity_paths.OVERLAID_OUTLINE,
            entity_paths.OVERLAID_SKELETON,
            entity_paths.CAPTION,
        ],
        name=coloured(_DRAWN),
        visual_bounds=rrb.VisualBounds2D(x_range=[0, width], y_range=[0, height]),
    )
    bodies = bodies_view(
        "pose on its path, fitted body; left side light",
        [entity_paths.FITTED_SKELETON, f"{entity_paths.FITTED_BODY}/**", entity_paths.PATH],
        rrb.EyeControls3D(
            kind=rrb.Eye3DKind.Orbital,
            position=[1.0, 1.4, 3.2],
            eye_up=[0, 1, 0],
            tracking_entity=entity_paths.FITTED_SKELETON,
        ),
        overrides={entity_paths.PATH: _SO_FAR},
    )
    share = width / height
    above = rrb.Horizontal(picture, bodies, column_shares=[min(1.6, max(0.8, share)), 1])
    gait = [
        series_view(f"{title}: left side light", _sides(entity, joint), span)
        for title, entity, joint, span in (
            ("hip flexion, degrees", entity_paths.LEG_ANGLES, "hip", None),
            ("knee flexion, degrees", entity_paths.LEG_ANGLES, "knee", None),
            ("gait phase, %", entity_paths.GAIT_PHASE, "", (0.0, 105.0)),
        )
    ]
    certainty = series_view(
        coloured(_SURE),
        [f"{entity_paths.OVERLAP_SHARES}/**", entity_paths.CONFIDENCE],
        (0.0, 1.05),
    )
    states = rrb.StateTimelineView(
        origin="/", contents=[entity_paths.STATE, entity_paths.MASK_STATE], name="pose and mask"
    )
    latency = [series_view("latency, ms", [entity_paths.LATENCY])] if live else []
    below = rrb.Horizontal(
        rrb.Vertical(*gait[:2]), rrb.Vertical(gait[2], certainty), rrb.Vertical(states, *latency)
    )
    return blueprint(
        [rrb.Vertical(above, below, row_shares=[1.7, 1]), texts_view()],
        [4.6, 1],
        frames_per_second,
        follow=live,
    )


def _sides(entity: str, joint: str = "") -> list[str]:
    return [
        entity_paths.below(entity, f"{side}_{joint}" if joint else side)
        for side in ("left", "right")
    ]
