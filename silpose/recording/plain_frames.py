"""Frames of a recording without the viewer around them: mask, pose on the mask, pose in 3D."""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Self

import cv2
import numpy as np
from numpy.typing import NDArray
from PIL import Image
from scipy.ndimage import gaussian_filter1d
from scipy.spatial.transform import Rotation

from silpose.core.errors import InputError
from silpose.core.pose_space import SPACES, PoseSpace
from silpose.core.types import Array, Mask
from silpose.model.image_overlay import joints_in_image
from silpose.recording import palette
from silpose.recording.plain_drawing import PALE, Picture, draw_line, with_title
from silpose.recording.read import read_recording
from silpose.recording.recorded_masks import read_masks, read_overlay
from silpose.silhouette import Camera

_DARK = 18, 19, 22  # as in the viewer
_SHOWN = ("fitted", "estimated", "tracker", "hypothesis_1", "mode_1")  # the first that there is
_BACKGROUND = (18, 19, 22)  # of a picture, the viewer's in the dark
_FINE = 2  # times as large as shown, so that edges become smooth
_BONE = 0.009  # radius of a bone, in panel widths
_EYE = Camera(elevation=12.0, focal_length=2.0)  # looks at the pose in 3D
_LIFT = 0.12  # metres by which the pose stands above what the eye looks at
_TURN = 35.0  # degrees that the eye swings to either side of the recorded camera,
_PERIOD = 90  # once in so many frames
_PAST = 1.5  # times as large as the person: the part of the image in which such a one stays
_AROUND = 32  # frames to either side over which a square that goes along is smoothed
_TILE, _TILES = 0.5, 2  # metres, and tiles to each side, of the ground


@dataclass(frozen=True, eq=False)
class PlainFrames:
    """Masks and poses of a recording, which can be drawn without its viewer.

    Attributes
    ----------
    masks : mapping of int to ndarray, each (H, W)
        By frame; empty where the recording has none.
    estimated, true : ndarray, shape (F, D), or None
        Poses, where the recording has them.
    space : PoseSpace
    overlay : mapping of int to ndarray, each (B, 2, 2), default={}
        Ends of the bones of the estimated pose in the mask, by frame, where the camera is known;
        elsewhere the pose gets the size of the person.
    """

    masks: Mapping[int, Mask]
    estimated: Array | None
    true: Array | None
    space: PoseSpace
    overlay: Mapping[int, Array] = field(default_factory=dict)

    @classmethod
    def read(cls, recording: str | Path) -> Self:
        """Read what can be drawn of a recording.

        Raises
        ------
        InputError
            If it cannot be read, or holds neither masks nor poses.
        """
        masks, recorded = read_masks(recording), read_recording(recording)
        by_name = {
            name.rpartition("/")[2]: _by_frame(recorded.frames, x)
            for name, x in recorded.poses.items()
        }
        true = by_name.pop("true", None)
        estimated = next((by_name[name] for name in (*_SHOWN, *by_name) if name in by_name), None)
        if not masks and estimated is None:
            raise InputError(f"'{recording}' holds neither masks nor poses")
        own = (s for s in SPACES.values() if s.columns == recorded.columns)
        space = next(own, SPACES["angles"])
        overlay = read_overlay(recording) if "fitted" in by_name else {}
        return cls(masks, estimated, true, space, overlay)

    def __len__(self) -> int:
        """Count the frames."""
        if self.estimated is not None:
            return len(self.estimated)
        return max(self.masks) + 1

    def film(self, frames: Sequence[int], width: int = 900) -> list[Picture]:
        """Draw frames, each as panels side by side.

        Parameters
        ----------
        frames : sequence of int
        width : int, default=900
            Pixels.

        Returns
        -------
        pictures : list of ndarray, each (H, W, 3)
            Red, green and blue.
        """
        size = width // len(self._panels)
        return [np.hstack(self._drawn(frame, size)) for frame in frames]

    def still(self, count: int = 6, size: int = 180) -> bytes:
        """Draw frames, evenly chosen, as the columns of one picture.

        Parameters
        ----------
        count : int, default=6
            Number of columns.
        size : int, default=180
            Pixels of each panel.

        Returns
        -------
        png : bytes
        """
        frames = np.unique(np.linspace(0, len(self) - 1, count + 2).astype(int)[1:-1])
        columns = [
            np.vstack(self._drawn(int(frame), size, titled=frame == frames[0])) for frame in frames
        ]
        file = io.BytesIO()
        Image.fromarray(np.hstack(columns)).save(file, format="png", optimize=True)
        return file.getvalue()

    def _drawn(self, frame: int, size: int, titled: bool = True) -> list[Picture]:
        """Draw the panels of a frame, each (size, size, 3)."""
        pictures = []
        for title, draw in self._panels.items():
            canvas = np.empty((_FINE * size, _FINE * size, 3), np.uint8)
            canvas[:] = _BACKGROUND
            draw(canvas, frame)
            smooth = cv2.resize(canvas, (size, size), interpolation=cv2.INTER_AREA)
            picture = np.asarray(smooth, np.uint8)
            pictures.append(with_title(picture, title) if titled else picture)
        return pictures

    @property
    def _panels(self) -> dict[str, Callable[[Picture, int], None]]:
        posed = self.estimated is not None
        panels = {
            "silhouette": (bool(self.masks), self._draw_mask),
            "estimate": (bool(self.masks) and posed, self._draw_overlay),
            "in 3D": (posed, self._draw_pose),
        }
        return {title: draw for title, (has, draw) in panels.items() if has}

    @cached_property
    def _window(self) -> tuple[dict[int, Array], float]:
        """Left and top by frame, and the size, of a square around the person.

        It stands still, unless the person walks past, as in films: then it goes along.
        """
        boxes = np.array([cv2.boundingRect(mask) for mask in self.masks.values()], dtype=float)
        frames, seen = np.array([*self.masks]), boxes[:, 2] > 0
        if not seen.any():
            boxes[:, 2:], seen = 1.0, ~seen
        low, sizes = boxes[seen, :2], boxes[seen, 2:]
        high, largest = low + sizes, float(sizes.max())
        ends = low.min(axis=0), high.max(axis=0)
        middle = np.tile(np.mean(ends, axis=0), (len(boxes), 1))
        size = float(np.max(ends[1] - ends[0]))
        if size > _PAST * largest:
            own = (low + high).T / 2
            middle = np.stack([np.interp(frames, frames[seen], part) for part in own], axis=1)
            beyond = np.pad(middle, [(_AROUND, _AROUND), (0, 0)], "reflect", reflect_type="odd")
            middle = gaussian_filter1d(beyond, _AROUND / 4, axis=0)[_AROUND:-_AROUND]
            size = largest
        size *= 1.12
        return dict(zip(frames.tolist(), middle - size / 2, strict=True)), size

    def _draw_mask(self, canvas: Picture, frame: int, colour: palette.Colour = PALE) -> None:
        if (mask := self.masks.get(frame)) is None:
            return
        corners, size = self._window
        (left, top), scale = corners[frame], len(canvas) / size
        place = np.array([[scale, 0, -scale * left], [0, scale, -scale * top]])
        inside = cv2.warpAffine(255 * mask, place, canvas.shape[:2], flags=cv2.INTER_LINEAR)
        canvas[inside > 127] = colour

    def _draw_overlay(self, canvas: Picture, frame: int) -> None:
        self._draw_mask(canvas, frame, palette.MASK)
        mask, pose = self.masks.get(frame), self._pose(self.estimated, frame)
        if mask is None or pose is None:
            return
        if (ends := self.overlay.get(frame)) is None:
            whole = not (mask[[0, -1]].any() or mask[:, [0, -1]].any())
            (points,) = joints_in_image(pose[None], [mask], np.array([whole]))
            ends = points[np.array(self.space.bones)]
        corners, size = self._window
        self._draw_bones(canvas, (ends - corners[frame]) / size, palette.ESTIMATED)

    def _draw_pose(self, canvas: Picture, frame: int) -> None:
        turn = Rotation.from_euler("Y", _TURN * np.sin(2 * np.pi * frame / _PERIOD), degrees=True)
        steps = _TILE * np.arange(-_TILES, _TILES + 1)
        ends = np.stack(np.broadcast_arrays(steps[:, None], 0, steps[[0, -1]]), axis=-1)
        tiles = np.concatenate([ends, ends[..., ::-1]])
        for line in tiles:
            ends = _seen(turn.apply(line), self._ground)
            draw_line(canvas, ends, palette.MASK, 0.2 * _BONE)
        for x, colour, radius in (
            (self.true, palette.TRUE, 1.6 * _BONE),
            (self.estimated, palette.ESTIMATED, _BONE),
        ):
            if (pose := self._pose(x, frame)) is not None:
                points = _seen(turn.apply(pose), _LIFT)
                self._draw_bones(canvas, points[np.array(self.space.bones)], colour, radius)

    @cached_property
    def _ground(self) -> float:
        """Height of the ground, below the root of a person who stands, metres."""
        assert self.estimated is not None, "there is a pose to draw"
        known = self.estimated[np.isfinite(self.estimated).all(axis=1)]
        return _LIFT - float(self.space.standing_height(known).mean()) if len(known) else 0.0

    def _pose(self, x: Array | None, frame: int) -> Array | None:
        """Joints (J, 3) of a frame; None where there is no pose."""
        if x is None or frame >= len(x) or not np.isfinite(x[frame]).all():
            return None
        return self.space.joints(x[frame : frame + 1])[0]

    def _draw_bones(
        self, canvas: Picture, ends: Array, colour: palette.Colour, radius: float = _BONE
    ) -> None:
        """Draw bones (B, 2, 2), left ones light and right ones dark; the panel's width is 1."""
        for own, (_, joint) in zip(ends, self.space.bones, strict=True):
            side = self.space.joint_names[joint].split("_")[0]
            draw_line(canvas, own, palette.shade(colour, side), radius)


def _by_frame(frames: NDArray[np.int64], x: Array) -> Array:
    """Put the poses of numbered frames where their numbers say; NaN where frames were left out."""
    if len(frames) != len(x):  # of one of several runs side by side
        return x
    placed = np.full((frames.max() + 1, x.shape[1]), np.nan)
    placed[frames] = x
    return placed


def _seen(points: Array, above: float) -> Array:
    """Project points (n, 3), metres, raised by some height, into a panel of width 1."""
    return np.asarray(_EYE.project(points + np.array([0.0, above, 0.0])) / _EYE.width)
