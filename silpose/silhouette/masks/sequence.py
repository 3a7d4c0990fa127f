"""`MaskSequence`: the masks of one source, and what was decided about it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from silpose.core.types import Mask


@dataclass(frozen=True)
class MaskSequence:
    """Masks of one source, in order; as a sequence, it is that of its masks.

    Attributes
    ----------
    masks : list of ndarray of 0 and 1, each of shape (H, W)
        Blank ones included; sizes may differ.
    names : list of str
        What each mask is called in messages and tables: its file, or ``frame 3``.
    source : str
        What the source is called in messages: its path, or ``the array``.
    encoding : str
        How its pixels were read, in words.
    frames_per_second : float or None, default=None
        The source's own rate, of a video or an animation; None if it has none.
    notes : tuple of str
        What was decided, a sentence each.
    doubts : tuple of str
        What may be wrong, a sentence each; each is also said as a `UserWarning`.
    ignored : tuple of str
        Files that were left out, each with the reason.
    """

    masks: list[Mask]
    names: list[str]
    source: str
    encoding: str
    frames_per_second: float | None = None
    notes: tuple[str, ...] = field(default=())
    doubts: tuple[str, ...] = field(default=())
    ignored: tuple[str, ...] = field(default=())

    def __len__(self) -> int:
        """Count the masks."""
        return len(self.masks)

    def __getitem__(self, frame: int) -> Mask:
        """Return one mask."""
        return self.masks[frame]

    def __iter__(self) -> Iterator[Mask]:
        """Go through the masks."""
        return iter(self.masks)
