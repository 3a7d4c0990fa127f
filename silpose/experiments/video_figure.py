"""The figure of a film: every tenth frame with its mask, the fitted outline and the skeleton."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import cv2
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array
from silpose.experiments.figures import headline
from silpose.model.video import VideoStep
from silpose.recording import palette
from silpose.recording.captions import coloured
from silpose.recording.figure_style import styled

_EVERY, _MOST = 10, 40  # frames apart, and panels; of a long film they are further apart
_COLUMNS = 10
_NARROW = 0.8  # width of a panel over its height
_MARGIN = 0.62  # half of a panel's height, in heights of the person
_PIXELS = 240  # height of a panel
_SURE, _DOUBTFUL = palette.ESTIMATED, palette.DOUBTFUL
_MASK, _OUTLINE = palette.hexed(palette.TRUE), palette.hexed(palette.EDGE)
_DRAWN = {
    "mask": palette.TRUE,
    "fitted outline": palette.EDGE,
    "skeleton": _SURE,
    "where doubtful": _DOUBTFUL,
}


@dataclass(frozen=True, eq=False)
class _Panel:
    """What is drawn of one step: a part of its picture, and lines in that."""

    number: int
    picture: NDArray[np.uint8]
    contours: list[Array]
    outline: Array
    skeleton: Array
    title: str
    doubtful: bool


class ContactSheet:
    """Panels of a film or of a camera, of which no more are kept than fit into a figure."""

    def __init__(self) -> None:
        self._every = _EVERY
        self._panels: list[_Panel] = []
        self._count = 0

    def add(self, step: VideoStep) -> None:
        """Take the next step, if it is a tenth; of a long film, a twentieth, and so on."""
        number, self._count = self._count, self._count + 1
        if number % self._every:
            return
        self._panels.append(_panel(number, step))
        if len(self._panels) > _MOST:
            self._every *= 2
            self._panels = [panel for panel in self._panels if panel.number % self._every == 0]

    @styled
    def figure(self, space: PoseSpace, title: str) -> Figure:
        """Draw all panels.

        Parameters
        ----------
        space : PoseSpace
        title : str
        """
        columns = min(_COLUMNS, len(self._panels))
        rows = -(-len(self._panels) // columns)
        figure = Figure(figsize=(max(1.35 * columns, 6), 1.9 * rows + 0.9), layout="constrained")
        headline(figure, title, f"Frame · confidence. Lines: {coloured(_DRAWN)}; left side light")
        every = list(figure.subplots(rows, columns, squeeze=False).flat)
        for axes in every:
            axes.set_axis_off()
        for axes, panel in zip(every, self._panels, strict=False):
            _draw(axes, space, panel)
        return figure


def contact_sheet_of(steps: Iterable[VideoStep]) -> ContactSheet:
    """Go through all steps."""
    sheet = ContactSheet()
    for step in steps:
        sheet.add(step)
    return sheet


def _panel(number: int, step: VideoStep) -> _Panel:
    left, top, width, height = cv2.boundingRect(step.mask)
    if not height:
        height, width = step.mask.shape
    centre = np.array([left + width / 2, top + height / 2])
    half = _MARGIN * max(height, width / _NARROW)
    scale = _PIXELS / (2 * half)
    size = (round(_NARROW * _PIXELS), _PIXELS)
    moved = np.hstack([scale * np.eye(2), np.c_[np.array(size) / 2 - scale * centre]])
    seen = 255 - 40 * np.repeat(step.mask[..., None], 3, axis=2)
    shown = seen if step.picture is None else step.picture
    white = (255, 255, 255)
    part = cv2.warpAffine(shown, moved, size, flags=cv2.INTER_AREA, borderValue=white)
    lines, _ = cv2.findContours(step.mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    poses = step.poses
    sure = "" if np.isnan(poses.confidence[0]) else f" · {poses.confidence[0]:.2f}"
    state = step.seen if step.seen != "person" else poses.state[0]
    words = "" if state in ("fitted", "tracking") else f"\n{state}"
    return _Panel(
        number, np.asarray(part, np.uint8),
        [line[:, 0] @ moved[:, :2].T + moved[:, 2] for line in lines],
        step.outline @ moved[:, :2].T + moved[:, 2], step.skeleton @ moved[:, :2].T + moved[:, 2],
        f"{step.index}{sure}{words}", bool(poses.doubtful[0]),
    )  # fmt: skip


def _draw(axes: Axes, space: PoseSpace, panel: _Panel) -> None:
    colour = _DOUBTFUL if panel.doubtful else _SURE
    axes.imshow(panel.picture)
    for line in panel.contours:
        axes.plot(*np.vstack([line, line[:1]]).T, color=_MASK, lw=0.8)
    if len(panel.outline):
        closed = np.vstack([panel.outline, panel.outline[:1]])
        axes.plot(*closed.T, color=_OUTLINE, lw=0.9)
    if np.isfinite(panel.skeleton).all():
        shades = palette.shades(colour, space.bones, space.joint_names)
        for bone, own in zip(space.bones, shades, strict=True):
            axes.plot(*panel.skeleton[list(bone)].T, color=palette.hexed(own), lw=1.2)
    height, width = panel.picture.shape[:2]
    axes.set(xlim=(0, width), ylim=(height, 0))
    axes.set_title(panel.title, fontsize=8, loc="center", pad=2, color=palette.hexed(colour))
