"""Where poses come from: a statistical walker, or BVH files, retargeted to our skeleton."""

from silpose.motion.bvh import BvhFolder
from silpose.motion.paths import Circle, Path, Spiral, Straight
from silpose.motion.takes import WalkerTakes
from silpose.motion.track import Motion
from silpose.motion.walker import Walker
from silpose.motion.walker_model import WalkerModel

__all__ = [
    "BvhFolder", "Circle", "Motion", "Path", "Spiral", "Straight", "Walker", "WalkerModel",
    "WalkerTakes",
]  # fmt: skip
