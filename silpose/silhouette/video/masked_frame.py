"""`MaskedFrame`: a picture with the mask of the person in it, and what is known of both."""

from __future__ import annotations

from dataclasses import dataclass, field
from time import monotonic

from silpose.core.types import Mask
from silpose.silhouette.person import MaskFacts
from silpose.silhouette.video.frame import Picture


@dataclass(frozen=True, eq=False)
class MaskedFrame:
    """One picture and its mask.

    Attributes
    ----------
    index : int
        Number of the frame in its source, from 0.
    time : float
        Seconds since the source's first frame.
    picture : ndarray of uint8, shape (H, W, 3)
        RGB, scaled down as the mask is.
    mask : ndarray of 0 and 1, shape (H, W)
        The person; blank where nobody is seen.
    facts : MaskFacts
        What is in the mask before one person was selected; of this one frame.
    moved : bool
        Whether the camera has moved, so that the mask is not to be trusted.
    switched : bool
        Whether a light was switched within the last frames, so that the mask is doubtful.
    learning : bool
        Whether the background is still being learnt.
    arrived : float, optional
        When the picture was there, as of `Frame`.
    gone : bool
        Whether the camera gives no pictures at this time.
    """

    index: int
    time: float
    picture: Picture
    mask: Mask
    facts: MaskFacts
    moved: bool = False
    switched: bool = False
    learning: bool = False
    arrived: float = field(default_factory=monotonic)
    gone: bool = False

    @property
    def seen(self) -> bool:
        """Whether the mask shows a person."""
        return bool(self.facts.seen[0])

    @property
    def state(self) -> str:
        """The gravest of what is known of the frame.

        ``gone``, ``moved``, ``learning``, ``switched``, why there is no person (``blank``,
        ``fragment`` or ``filled``), or ``person``.
        """
        for name in ("gone", "moved", "learning", "switched"):
            if getattr(self, name):
                return name
        if self.seen:
            return "person"
        return self.facts.states()[0] or "blank"
