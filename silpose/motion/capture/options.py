"""How a motion capture file is to be read, where it does not say so itself."""

from __future__ import annotations

from dataclasses import dataclass, field

from silpose.core.errors import InputError
from silpose.motion.capture.naming import Names, check_given

AXES = ("x", "y", "z", "-x", "-y", "-z")
"""Axes that may point up."""

SLOWEST, FASTEST = 1.0, 10_000.0
"""Range of plausible frame rates, frames per second."""


@dataclass(frozen=True)
class CaptureOptions:
    """Settings of reading that hold for every file of a folder.

    Parameters
    ----------
    frames_per_second : float, default=15.0
        Frame rate of the result.
    frame_rate : float or None, default=None
        Frame rate of the files, in place of what they say.
    up : {"auto", "x", "y", "z", "-x", "-y", "-z"}, default="auto"
        Axis of the files that points up; "auto" takes it from the format and the motion.
    mirror : bool, default=False
        Whether to mirror the motion: for files whose axes are left-handed, or whose left and
        right are exchanged.
    joints : mapping of str to sequence of str, default={}
        Names of joints, in place of those that are known.

    Raises
    ------
    InputError
        If a value cannot be used.
    """

    frames_per_second: float = 15.0
    frame_rate: float | None = None
    up: str = "auto"
    mirror: bool = False
    joints: Names = field(default_factory=dict)

    def __post_init__(self) -> None:
        if not 0 < self.frames_per_second < float("inf"):
            raise InputError(
                f"motion.frames_per_second must be a positive number, not {self.frames_per_second}"
            )
        if self.frame_rate is not None and not SLOWEST <= self.frame_rate <= FASTEST:
            raise InputError(
                f"motion.frame_rate must be {SLOWEST:g} to {FASTEST:g} frames per second, not "
                f"{self.frame_rate}"
            )
        if self.up not in ("auto", *AXES):
            raise InputError(f"motion.up must be one of auto, {', '.join(AXES)}, not '{self.up}'")
        object.__setattr__(self, "joints", check_given(self.joints))
