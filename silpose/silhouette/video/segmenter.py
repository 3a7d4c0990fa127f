"""`Segmenter`: the mask of the person in each picture of a camera that stands still."""

from __future__ import annotations

import warnings

import numpy as np

from silpose.core.types import Mask
from silpose.silhouette.video.backgrounds import Background
from silpose.silhouette.video.camera_motion import CameraMotion
from silpose.silhouette.video.clean_up import connected_to, fill_holes, morphology
from silpose.silhouette.video.followed_person import FollowedPerson
from silpose.silhouette.video.frame import Frame
from silpose.silhouette.video.masked_frame import MaskedFrame

_LOOK_EVERY = 5  # frames between two looks at whether the camera moves
_DOUBTED = 3  # frames for which a mask is doubtful after a light was switched


class Segmenter:
    """Segments frame after frame.

    Parameters
    ----------
    background : Background
    motion : CameraMotion or None
        None where masks are right of a camera that moves, too.
    person : FollowedPerson
    opening, closing : float
        Width of what morphology removes and bridges, as a share of the picture's longer side.
    smallest : float
        Share of the picture that a component must cover.
    hole : float
        Share of the foreground up to which a hole is filled.
    learning : int, default=0
        First frames in which the background is still being learnt.
    source : str, default="the stream"
        What the source is called in messages.
    """

    def __init__(
        self,
        background: Background,
        motion: CameraMotion | None,
        person: FollowedPerson,
        *,
        opening: float,
        closing: float,
        smallest: float,
        hole: float,
        learning: int = 0,
        source: str = "the stream",
    ) -> None:
        self.background = background
        self.motion = motion
        self.person = person
        self.opening, self.closing = opening, closing
        self.smallest, self.hole = smallest, hole
        self.learning = learning
        self.source = source
        self._steps = 0
        self._switched = -_DOUBTED
        self._moved = self._said_moved = False

    def step(self, frame: Frame) -> MaskedFrame:
        """Segment the next frame.

        Warns
        -----
        UserWarning
            Once, when the camera moves, and once if there are several people and none is chosen.
        """
        picture = frame.picture
        if frame.gone:
            nobody, facts = self.person.step(np.zeros(picture.shape[:2], np.uint8), frame.time)
            return MaskedFrame(
                frame.index, frame.time, picture, nobody, facts, arrived=frame.arrived, gone=True
            )
        side, pixels = max(picture.shape[:2]), picture.shape[0] * picture.shape[1]
        found = self.background.step(picture)
        mask = morphology(found.weak, self.opening * side, self.closing * side)
        mask = connected_to(mask, found.strong, self.smallest * pixels)
        mask = fill_holes(mask, self.hole * float(mask.sum()))
        alone, facts = self.person.step(mask, frame.time)
        if self.motion is not None and self._steps % _LOOK_EVERY == 0:
            self._look_at_motion(frame, mask, self.motion)
        if found.switched:
            self._switched = self._steps
        doubted = self._steps < self._switched + _DOUBTED
        learning = self._steps < self.learning
        self._steps += 1
        return MaskedFrame(
            frame.index, frame.time, picture, alone, facts, self._moved, doubted, learning,
            frame.arrived,
        )  # fmt: skip

    def _look_at_motion(self, frame: Frame, people: Mask, motion: CameraMotion) -> None:
        self._moved = motion.step(frame.picture, people)
        if self._moved and not self._said_moved:
            self._said_moved = True
            warnings.warn(
                f"the camera of {self.source} moves, first seen at {frame.time:.1f} s, or noise or "
                "darkness hides the scene: masks are right only of a camera that stands still; put "
                "it on a stand, give it light, or give masks of another origin with silpose "
                "predict",
                stacklevel=3,
            )
