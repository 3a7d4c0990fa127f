"""A walking person, as the file has it and as joints by name."""

import numpy as np
import pytest
from walk_files import WalkFile

from silpose.core.skeleton import JOINTS
from silpose.motion.capture.source_motion import SourceMotion


@pytest.fixture
def walking():
    """Give a walk's motion, +Y up and in metres; keywords are those of `WalkFile`."""

    def walk(**kind):
        rotations, positions = WalkFile(**kind).walk()
        positions = {n.replace("wrist/end", "hand"): p for n, p in positions.items()}
        known = {n: p for n, p in positions.items() if "/end" not in n and "spine1" not in n}
        return SourceMotion({n: r for n, r in rotations.items() if n in JOINTS}, known)

    return walk


@pytest.fixture
def mirrored():
    """Reflect a motion."""
    return lambda motion: motion.transformed(np.diag([-1.0, 1, 1]))
