"""How things are drawn in recordings of films and cameras."""

from __future__ import annotations

from collections.abc import Mapping

import rerun as rr

from silpose.core.pose_space import ANGLES
from silpose.recording import entity_paths, palette
from silpose.recording.stream import FanOut

_SIDES = {side: palette.shade(palette.ESTIMATED, side) for side in ("left", "right")}


def log_video_styles(recording: rr.RecordingStream | FanOut, size: tuple[int, ...]) -> None:
    """Log what holds for all frames of a film or a camera.

    Parameters
    ----------
    recording : rerun.RecordingStream
    size : tuple of int
        Height and width of the pictures, pixels.
    """
    height, width = size
    thin, thick = rr.Radius.ui_points(0.8), rr.Radius.ui_points(1.8)
    below = entity_paths.below
    styles: dict[str, rr.AsComponents] = {
        entity_paths.CAMERA: rr.Pinhole(focal_length=height, width=width, height=height),
        entity_paths.OVERLAID_OUTLINE: rr.LineStrips2D.from_fields(colors=palette.EDGE, radii=thin),
        entity_paths.OVERLAID_SKELETON: rr.LineStrips2D.from_fields(radii=thick),
        entity_paths.CAPTION: rr.Points2D.from_fields(
            positions=[[0.5 * width, 0.03 * height]], radii=0.1, colors=palette.NEUTRAL
        ),
        entity_paths.FITTED_SKELETON: rr.LineStrips3D.from_fields(radii=0.016),
        entity_paths.PATH: rr.Points3D.from_fields(colors=palette.NEUTRAL, radii=0.015),
        entity_paths.FITTED_POSE: rr.AnyValues(columns=list(ANGLES.columns)),
        below(entity_paths.OVERLAP_SHARES, "fitted"): _line("overlap", palette.ESTIMATED),
        entity_paths.CONFIDENCE: _line("confidence", palette.NEUTRAL),
        entity_paths.FITTED_HEADING: _line("heading", palette.ESTIMATED),
        entity_paths.LATENCY: _line("latency", palette.NEUTRAL),
        entity_paths.STATE: _states(
            {**palette.STATES, **palette.FIT_STATES, **palette.ESTIMATE_STATES}
        ),
        entity_paths.MASK_STATE: _states(palette.MASK_STATES),
    }
    for side, colour in _SIDES.items():
        styles[below(entity_paths.GAIT_PHASE, side)] = _line(side, colour)
        for joint in ("hip", "knee"):
            styles[below(entity_paths.LEG_ANGLES, f"{side}_{joint}")] = _line(side, colour)
    for entity, style in styles.items():
        recording.log(entity, style, static=True)


def _line(name: str, colour: palette.Colour) -> rr.SeriesLines:
    return rr.SeriesLines(colors=colour, names=name, widths=1.5)


def _states(colours: Mapping[str, palette.Colour]) -> rr.StateConfiguration:
    names = list(colours)
    return rr.StateConfiguration(values=names, labels=names, colors=list(colours.values()))
