"""Synthetic walks, drawn from a statistical model of walking, which need no data.

`WalkerTakes` draws walkers from `WalkerModel` and lets them walk along paths; the model's file,
``walker.npz``, was fitted to motion capture by `fit_walker`.
"""

from silpose.motion.walker.paths import Circle, Path, Spiral, Straight
from silpose.motion.walker.walker import Walker
from silpose.motion.walker.walker_model import WalkerModel
from silpose.motion.walker.walker_takes import WalkerTakes

__all__ = ["Circle", "Path", "Spiral", "Straight", "Walker", "WalkerModel", "WalkerTakes"]
