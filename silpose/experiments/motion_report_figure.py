"""The figure of `motion_report`: each take from the front, from the right and from above."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from silpose.core import skeleton
from silpose.core.pose_space import ANGLES
from silpose.core.types import Array
from silpose.experiments.figures import NEUTRAL, SERIES, TRUE, draw_skeleton, headline, without_ink
from silpose.motion import CapturedTake
from silpose.recording import palette
from silpose.recording.captions import coloured
from silpose.recording.figure_style import DIM, HAIRLINE, styled

_FRAMES = 6  # of each view
_APART = 1.1  # metres between them
_DRAWN = {"the file's own joints": palette.NEUTRAL, "silpose's skeleton": palette.TRUE}
_ARROWS = 12  # in the view from above


@styled
def motion_figure(takes: Mapping[str, CapturedTake]) -> Figure:
    """Draw poses on the skeleton (blue, the left side light) over the file's own joints (grey).

    Parameters
    ----------
    takes : mapping of str to CapturedTake
        By name.
    """
    figure = Figure(figsize=(13, 1.9 * len(takes) + 1.2), layout="constrained")
    grid = figure.subplots(len(takes), 3, squeeze=False, width_ratios=(1.6, 1.6, 1))
    for row, (name, take) in zip(grid, takes.items(), strict=True):
        _draw_poses(row[0], take, (0, 1))
        _draw_poses(row[1], take, (2, 1))
        _draw_path(row[2], take)
        row[0].set_title(f"{name}: {take.report.speed:.2f} m/s, from the front")
    grid[0, 1].set_title("from the right")
    grid[0, 2].set_title("path of the hips, from above")
    headline(
        figure, "What is understood of the motion: its sides, its ground, its way",
        f"{coloured(_DRAWN).capitalize()}; left limbs are light, right ones dark. "
        "Arrows: where the person faces",
    )  # fmt: skip
    return figure


def _draw_poses(axes: Axes, take: CapturedTake, plane: tuple[int, int]) -> None:
    """Draw a few frames beside each other, turned so that the person faces the same way in all."""
    frames = np.unique(np.linspace(0, len(take.angles) - 1, _FRAMES).astype(int))
    ours = ANGLES.joints(ANGLES.from_angles(take.angles[frames])) + take.root_position[frames, None]
    for k, frame in enumerate(frames):
        back = _about_vertical(-take.angles[frame, 0])
        middle = take.root_position[frame] * (1.0, 0.0, 1.0)
        shift = np.array([k * _APART, 0.0])
        theirs = {
            name: (back @ (positions[frame] - middle))[list(plane)] + shift
            for name, positions in take.source.positions.items()
        }
        for child in theirs:
            parent = _known_parent(child, theirs)
            if parent is not None:
                axes.plot(*np.array([theirs[parent], theirs[child]]).T, color=HAIRLINE, lw=4)
        points = ((ours[k] - middle) @ back.T)[:, list(plane)] + shift
        draw_skeleton(axes, ANGLES, points, palette.TRUE, 1.5)
    axes.axhline(0.0, color=NEUTRAL, lw=0.5)
    axes.set(aspect="equal", xlim=(-0.9, (_FRAMES - 1) * _APART + 0.9), ylim=(-0.15, 1.95))
    without_ink(axes)


def _known_parent(joint: str, known: Mapping[str, Array]) -> str | None:
    parent = skeleton.PARENTS.get(joint)
    while parent is not None and parent not in known:
        parent = skeleton.PARENTS.get(parent)
    return parent


def _draw_path(axes: Axes, take: CapturedTake) -> None:
    """Draw where the hips go, seen from above, and where the person faces."""
    x, z = take.root_position[:, 0], take.root_position[:, 2]
    axes.plot(x, -z, color=TRUE, lw=1.2)
    axes.plot(x[0], -z[0], "o", color=TRUE, ms=4)
    few = np.unique(np.linspace(0, len(x) - 1, _ARROWS).astype(int))
    heading = np.deg2rad(take.angles[few, 0])
    axes.quiver(
        x[few], -z[few], np.sin(heading), -np.cos(heading),
        color=SERIES[0], angles="xy", scale=11, width=0.009,
    )  # fmt: skip
    size = max(float(np.ptp(x)), float(np.ptp(z)), 1.0) / 2 + 0.4
    middle = (x.min() + x.max()) / 2, -(z.min() + z.max()) / 2
    axes.set(aspect="equal", xticks=[], yticks=[])
    axes.set(xlim=(middle[0] - size, middle[0] + size), ylim=(middle[1] - size, middle[1] + size))
    axes.spines[:].set(visible=True, color=HAIRLINE)
    axes.text(0.03, 0.03, f"{2 * size:.1f} m wide", transform=axes.transAxes, color=DIM)


def _about_vertical(degrees: float) -> Array:
    """Rotation about the vertical, shape (3, 3)."""
    cosine, sine = np.cos(np.deg2rad(degrees)), np.sin(np.deg2rad(degrees))
    return np.array([[cosine, 0.0, sine], [0.0, 1.0, 0.0], [-sine, 0.0, cosine]])
