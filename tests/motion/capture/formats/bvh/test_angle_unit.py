import numpy as np
import pytest

from silpose.motion.capture.formats.bvh.angle_unit import degrees_per_unit
from silpose.motion.capture.formats.bvh.hierarchy import Node

NODES = [
    Node("hips", -1, 1, channels=["xp", "yp", "zp", "yr"], offset=(9.0, 9, 9)),
    Node("knee", 0, 1, channels=["xr"], offset=(0.0, -90, 0)),
]


def values(travel, rotation, frames=20):
    share = np.linspace(0, 1, frames)
    zero = np.zeros(frames)
    return np.stack([travel * share, zero + 90, zero, zero, rotation * np.sin(9 * share)], axis=1)


def test_radians_of_a_walk():
    factor, (note,) = degrees_per_unit(NODES, values(300, 1.2))
    assert factor == pytest.approx(180 / np.pi) and "read as radians" in note


def test_radians_without_travel_are_suspected_only():
    factor, (note,) = degrees_per_unit(NODES, values(3, 1.2))
    assert factor == 1 and "if they are in radians" in note


@pytest.mark.parametrize(("travel", "rotation"), [(300, 60), (300, 8), (300, 0), (0, 0.1)])
def test_degrees(travel, rotation):
    assert degrees_per_unit(NODES, values(travel, rotation)) == (1.0, ())


def test_one_frame_tells_nothing():
    assert degrees_per_unit(NODES, values(300, 1.2, frames=1)) == (1.0, ())
