"""Where poses come from: a statistical walker, or motion capture, put on our skeleton."""

from silpose.motion.bvh_export import save_bvh
from silpose.motion.capture.motion_folder import MotionFolder
from silpose.motion.mirror import mirrored
from silpose.motion.motion import Motion
from silpose.motion.walker.paths import Circle, Path, Spiral, Straight
from silpose.motion.walker.walker import Walker
from silpose.motion.walker.walker_model import WalkerModel
from silpose.motion.walker.walker_takes import WalkerTakes

__all__ = [
    "Circle", "Motion", "MotionFolder", "Path", "Spiral", "Straight", "Walker", "WalkerModel",
    "WalkerTakes", "mirrored", "save_bvh",
]  # fmt: skip
