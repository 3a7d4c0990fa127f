"""A walk of a walker, sampled at a high rate, and reports of motion."""

import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.evaluation.gait import Walk, gait_report
from silpose.motion import Straight, WalkerModel


def walked(seconds=8.0, rate=120.0, seed=0, path=None):
    """A `Motion` of the mean walker."""
    rng = np.random.default_rng(seed)
    walker = WalkerModel.load().sample(rng, 0.3)
    return walker.walk(path or Straight(30.0), seconds, rate, rng)


def walk_of(motion, every=1, **options):
    """A `Walk` of a `Motion`, of every so many frames, with its path unless another is given."""
    part = {"path": motion.root_position[::every], **options}
    x = ANGLES.from_angles(motion.angles[::every])
    return Walk.from_poses(x, frames_per_second=motion.frames_per_second / every, **part)


@pytest.fixture(scope="session")
def straight():
    """A straight walk of 8 s at 120 frames per second."""
    return walked()


@pytest.fixture(scope="session")
def straight_report(straight):
    """Its report at 30 frames per second."""
    return gait_report(walk_of(straight, 4))


@pytest.fixture(scope="session")
def report_of():
    """Make the report of a `Motion`: `walk_of`, then `gait_report`."""
    return lambda motion, every=1, **options: gait_report(walk_of(motion, every, **options))


@pytest.fixture(scope="session")
def make_walk():
    """Make a `Walk` of a `Motion`."""
    return walk_of


@pytest.fixture(scope="session")
def make_motion():
    """Make a motion of a walker."""
    return walked
