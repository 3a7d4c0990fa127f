"""The figure of `motion_report`: each take from the front, from the right and from above."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from silpose.core import skeleton
from silpose.core.pose_space import ANGLES
from silpose.core.types import Array
from silpose.experiments.figures import ESTIMATED, NEUTRAL, TRUE
from silpose.motion import CapturedTake
from silpose.recording import palette

_FRAMES = 6  # of each view
_APART = 1.1  # metres between them
_ARROWS = 12  # in the view from above
_THEIRS = "#b9bec4"
_LEFT, _RIGHT = TRUE, palette.hexed(palette.shade(palette.TRUE_ON_WHITE, "right"))


def motion_figure(takes: Mapping[str, CapturedTake]) -> Figure:
    """Draw poses on the skeleton (blue, the left side light) over the file's own joints (grey).

    Parameters
    ----------
    takes : mapping of str to CapturedTake
        By name.
    """
    figure = Figure(figsize=(13, 2.2 * len(takes) + 0.4), layout="constrained")
    grid = figure.subplots(len(takes), 3, squeeze=False, width_ratios=(1.6, 1.6, 1))
    for row, (name, take) in zip(grid, takes.items(), strict=True):
        _draw_poses(row[0], take, (0, 1))
        _draw_poses(row[1], take, (2, 1))
        _draw_path(row[2], take)
        row[0].set_title(f"{name}: {take.report.speed:.2f} m/s", fontsize=8, loc="left")
    for axes, title in zip(grid[-1], ("from the front", "from the right", "path, facing"),
                           strict=True):  # fmt: skip
        axes.set_xlabel(title, fontsize=8)
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
                axes.plot(*np.array([theirs[parent], theirs[child]]).T, color=_THEIRS, lw=4)
        points = ((ours[k] - middle) @ back.T)[:, list(plane)] + shift
        for bone in ANGLES.bones:
            side = ANGLES.joint_names[bone[1]].split("_")[0]
            colour = {"left": _LEFT, "right": _RIGHT}.get(side, TRUE)
            axes.plot(*points[list(bone)].T, color=colour, lw=1.3, solid_capstyle="round")
    axes.axhline(0.0, color=NEUTRAL, lw=0.5)
    axes.set(aspect="equal", xlim=(-0.9, (_FRAMES - 1) * _APART + 0.9), ylim=(-0.15, 1.95))
    axes.set(xticks=[], yticks=[])
    axes.spines[:].set_visible(False)


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
        color=ESTIMATED, angles="xy", scale=11, width=0.009,
    )  # fmt: skip
    size = max(float(np.ptp(x)), float(np.ptp(z)), 1.0) / 2 + 0.4
    middle = (x.min() + x.max()) / 2, -(z.min() + z.max()) / 2
    axes.set(aspect="equal", xticks=[], yticks=[])
    axes.set(xlim=(middle[0] - size, middle[0] + size), ylim=(middle[1] - size, middle[1] + size))
    axes.spines[:].set_color("#c8ccd0")
    axes.text(
        0.02, 0.03, f"{2 * size:.1f} m", transform=axes.transAxes, fontsize=7, color="#7d838b"
    )


def _about_vertical(degrees: float) -> Array:
    """Rotation about the vertical, shape (3, 3)."""
    cosine, sine = np.cos(np.deg2rad(degrees)), np.sin(np.deg2rad(degrees))
    return np.array([[cosine, 0.0, sine], [0.0, 1.0, 0.0], [-sine, 0.0, cosine]])
