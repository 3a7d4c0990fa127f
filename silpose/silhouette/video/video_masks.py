"""`VideoMasks`: masks of a person, from a film, a folder of pictures, a camera or a stream."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Iterator

from silpose.core.errors import InputError
from silpose.silhouette.masks import MaskSequence
from silpose.silhouette.person import check_person
from silpose.silhouette.video.backgrounds import ADAPTIVE, Background, Shadows
from silpose.silhouette.video.camera_motion import CameraMotion
from silpose.silhouette.video.checks import check_background, check_numbers
from silpose.silhouette.video.followed_person import FollowedPerson
from silpose.silhouette.video.frame import Frame, Picture
from silpose.silhouette.video.given_masks import GivenMasks, given_masks
from silpose.silhouette.video.learnt_background import learn_background, sample_of
from silpose.silhouette.video.masked_frame import MaskedFrame
from silpose.silhouette.video.neural_background import NeuralBackground
from silpose.silhouette.video.open_source import open_source
from silpose.silhouette.video.segmenter import Segmenter
from silpose.silhouette.video.threaded import Threaded, in_real_time
from silpose.silhouette.video.whole_clip import mask_sequence

_LOOKED_AT = 8  # pictures by which masks are told from pictures of a scene


class VideoMasks:
    """Masks of one person in front of a camera that stands still, by subtracting the background.

    Parameters
    ----------
    source : path, int or str
        A video, a folder of pictures, the index of a camera (also as text), or the address of a
        stream, such as ``rtsp://…``.
    background : str or None, default=None
        What the scene is without the person: median of a sample of the clip, mog2 or knn (learnt
        and adapted as by OpenCV; for a camera, too), or the path of a picture of the empty scene.
        None is median for a clip, mog2 for a camera; a clip or folder whose pictures are masks
        already is taken as it is, without a background and morphology.
        Or selfie: there is none, as a neural network finds people, MediaPipe's.
    samples : int, default=40
        Frames of a clip, evenly over it, from which the background is learnt beforehand.
    history : int, default=500
        Frames over which mog2 and knn learn and forget.
    threshold : float, default=20
        Grey levels by which a pixel of the person differs from the background, at least; noise
        above that is measured, and raises it.
    shadows : bool, default=True
        Whether shadows are told from the person by brightness and colour, and left out.
    shadow_darkest : float, default=0.6
        Brightness of the darkest shadow, as a share of the background's.
    shadow_chroma : float, default=0.04
        How far from the background's colour a shadow may be, as a share of its brightness.
    opening : float, default=0.004
        Width of specks and threads that are removed, as a share of the picture's longer side.
    closing : float, default=0.008
        Width of gaps that are bridged, as a share of the picture's longer side.
    smallest : float, default=0.001
        Share of the picture that a piece of the person covers, at least.
    hole : float, default=0.004
        Share of the foreground up to which a hole is filled.
    person : str or None, default=None
        Who it is if there are several: largest, left, right, tracked, or a number from the left;
        null follows the largest of the first frame.
    longest_side : int, default=960
        Pixels of the longer side, to which larger pictures are scaled down.
    camera_shift : float, default=0.004
        Shift of the whole picture from which the camera counts as moved, as a share of its longer
        side.
    frames_per_second : float or None, default=None
        Frames per second, if not those that the source tells.
    first : int, default=0
        Frame with which to begin; the background is learnt from the whole clip.
    last : int or None, default=None
        Last frame; null goes on to the end.
    real_time : bool, default=False
        Whether a film plays at its own rate, dropping frames rather than falling behind, as a
        camera does.
    environment : str or None, default=None
        Folder of a Python environment that has MediaPipe 0.10.21, for selfie; null is this one.

    Raises
    ------
    InputError
        If there is no such source, it gives no pictures, or a parameter has no meaning.

    Notes
    -----
    Iterating decodes in one thread and segments in another; no more than a few frames, and the
    sample for the background, are in memory. Once begun, a camera cannot be iterated over again.
    """

    def __init__(
        self,
        source: str | os.PathLike[str] | int,
        background: str | None = None,
        samples: int = 40,
        history: int = 500,
        threshold: float = 20,
        shadows: bool = True,
        shadow_darkest: float = 0.6,
        shadow_chroma: float = 0.04,
        opening: float = 0.004,
        closing: float = 0.008,
        smallest: float = 0.001,
        hole: float = 0.004,
        person: str | int | None = None,
        longest_side: int = 960,
        camera_shift: float = 0.004,
        frames_per_second: float | None = None,
        first: int = 0,
        last: int | None = None,
        real_time: bool = False,
        environment: str | None = None,
    ) -> None:
        self.samples, self.history = samples, history
        self.threshold = threshold
        self.shadows = shadows
        self.shadow_darkest, self.shadow_chroma = shadow_darkest, shadow_chroma
        self.opening, self.closing = opening, closing
        self.smallest, self.hole = smallest, hole
        self.person = check_person(person)
        self.longest_side = longest_side
        self.camera_shift = camera_shift
        self.first, self.last = first, last
        self.real_time, self.environment = real_time, environment
        check_numbers(self, frames_per_second)
        if background is not None:
            check_background(background)
        self.frames = open_source(source, longest_side, frames_per_second)
        if self.frames.is_live and background == "median":
            self.frames.close()
            raise InputError(
                f"{self.frames.name} has no whole clip to take a median of: give "
                "silhouette.video.background=mog2, knn, selfie, or the path of a picture of the "
                "empty scene (in Python background='mog2' and so on)"
            )
        self._chosen = background is not None
        self.background = background or ("mog2" if self.frames.is_live else "median")
        self.dropped = 0

    @property
    def frames_per_second(self) -> float | None:
        """Frames per second that the source tells, or was given; None if neither."""
        return self.frames.frames_per_second

    @property
    def is_live(self) -> bool:
        """Whether frames come when they do, as of a camera: some may have to be dropped."""
        return self.frames.is_live or self.real_time

    def __iter__(self) -> Iterator[MaskedFrame]:
        """Decode and segment frame by frame, each in a thread of its own."""
        segmenter = self._segmenter()
        frames = in_real_time(self.frames) if self.real_time else self.frames
        decoded = Threaded(frames, self.is_live)
        masked = Threaded(self._segmented(decoded, segmenter), self.is_live, "segmenter")
        seen = False
        for frame in masked:
            self.dropped = decoded.dropped + masked.dropped
            seen = True
            yield frame
        if not seen:
            raise InputError(
                f"there is no frame {self.first} in {self.frames.name}: give an earlier one as "
                "first"
            )

    def masks(self) -> MaskSequence:
        """Segment a whole clip.

        Returns
        -------
        sequence : MaskSequence
            As `silpose.silhouette.read_masks` returns, to be given to `PoseModel.predict` with
            ``blank="nan"``; at an even rate, whatever the clip's own is.

        Raises
        ------
        InputError
            If the source is a camera or a stream, which does not end.
        """
        if self.frames.is_live:
            raise InputError(
                f"{self.frames.name} does not end: go through its frames with a for loop, and "
                "give each mask to model.stream(…).step"
            )
        return mask_sequence(self, self.frames.name, self.frames_per_second)

    def _segmented(self, decoded: Iterable[Frame], segmenter: Segmenter) -> Iterator[MaskedFrame]:
        for frame in decoded:
            if self.last is not None and frame.index > self.last:
                break
            if frame.index >= self.first:
                yield segmenter.step(frame)

    def _segmenter(self) -> Segmenter:
        adapts = self.background in ADAPTIVE
        unlearnt = adapts and self.frames.is_live
        learns = self.background in (*ADAPTIVE, "median") and not self.frames.is_live
        pictures = sample_of(self.frames, self.samples) if learns else []
        given = self._given(pictures)
        rests = CameraMotion(self.camera_shift, renew=20 if adapts else None)
        return Segmenter(
            given or self._background(pictures),
            None if given or self.background == "selfie" else rests,
            FollowedPerson(self.person),
            opening=0 if given else self.opening,
            closing=0 if given else self.closing,
            smallest=self.smallest,
            hole=self.hole,
            learning=min(30, self.history) if unlearnt else 0,
            source=self.frames.name,
        )

    def _given(self, sample: list[Picture]) -> GivenMasks | None:
        """Whether the pictures are masks already, where no background was chosen."""
        if self._chosen or self.frames.is_live:
            return None
        given = given_masks(sample[:: -(-len(sample) // _LOOKED_AT) or 1])
        if given is not None:
            warnings.warn(
                f"the pictures of {self.frames.name} are masks already, and taken as they are: if "
                "they are none, give silhouette.video.background=median (in Python "
                "background='median')",
                stacklevel=3,
            )
        return given

    def _background(self, sample: list[Picture]) -> Background:
        if self.background == "selfie":
            return NeuralBackground(self.environment)
        shadows = Shadows(self.shadow_darkest, self.shadow_chroma) if self.shadows else None
        return learn_background(
            self.background, self.frames, sample, self.history, self.threshold, shadows
        )
