"""What the header of a film tells, and when it is wrong."""

from __future__ import annotations

from pathlib import Path

FASTEST = 1000
"""Frames per second; containers without a rate tell their clock's."""

BARE = (".h264", ".264", ".avc", ".h265", ".265", ".hevc", ".mjpeg", ".mjpg", ".m2v")
"""Suffixes of films without a container, which tell neither rate nor times."""

_WHOLE = 0.9  # share of the frames announced, below which a film is cut off


def known_rate(told: float) -> float | None:
    """Return the rate that a container tells; None if that is none."""
    return told if 0 < told < FASTEST else None


def cut_off(file: Path, frames: int, announced: int, lasting: float) -> str:
    """Say that a film has fewer frames than it announces; nothing if it has about as many.

    Parameters
    ----------
    file : Path
    frames, announced : int
        Frames that were read, and by the header; some containers announce those of an even rate.
    lasting : float
        Intervals of the rate between the first frame and the last, by their time stamps.
    """
    if max(frames, lasting + 1) >= _WHOLE * announced:
        return ""
    return (
        f"the video '{file}' ends after {frames} of {announced} frames: it is cut off or damaged, "
        "or of another size from there on"
    )
