"""Where poses come from: a statistical walker, or motion capture, put on our skeleton."""

from silpose.motion.folder import MotionFolder
from silpose.motion.mirror import mirrored
from silpose.motion.paths import Circle, Path, Spiral, Straight
from silpose.motion.save import save_bvh
from silpose.motion.takes import WalkerTakes
from silpose.motion.track import Motion
from silpose.motion.walker import Walker
from silpose.motion.walker_model import WalkerModel

__all__ = [
    "Circle", "Motion", "MotionFolder", "Path", "Spiral", "Straight", "Walker", "WalkerModel",
    "WalkerTakes", "mirrored", "save_bvh",
]  # fmt: skip
