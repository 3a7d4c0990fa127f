"""Motion: poses over time, from statistical walkers or from motion capture.

`capture` reads BVH and AMASS files and puts them on the skeleton, `walker` synthesises walks;
`silpose.dataset` renders either.
"""

from silpose.motion.bvh_export import save_bvh
from silpose.motion.capture import CapturedTake, CaptureReport, MotionFolder
from silpose.motion.mirror import mirrored
from silpose.motion.motion import Motion
from silpose.motion.motion_source import MotionSource
from silpose.motion.walker import (
    Circle,
    Path,
    Spiral,
    Straight,
    Walker,
    WalkerModel,
    WalkerTakes,
)

__all__ = [
    "CaptureReport",
    "CapturedTake",
    "Circle",
    "Motion",
    "MotionFolder",
    "MotionSource",
    "Path",
    "Spiral",
    "Straight",
    "Walker",
    "WalkerModel",
    "WalkerTakes",
    "mirrored",
    "save_bvh",
]
