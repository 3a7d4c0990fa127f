import numpy as np
import pytest

from silpose.motion.capture.source_motion import SourceMotion


@pytest.fixture
def motion():
    azimuth = np.deg2rad([0.0, 90.0, 200.0])
    hips = np.stack([np.cos(azimuth), 0.1 * np.ones(3), -np.sin(azimuth)], axis=1)
    positions = {"root": np.zeros((3, 3)), "left_hip": hips, "right_hip": -hips}
    return SourceMotion({"root": np.tile(np.eye(3), (3, 1, 1))}, positions)


def test_directions_are_unit_vectors(motion):
    line = motion.direction("right_hip", "left_hip")
    np.testing.assert_allclose(np.linalg.norm(line, axis=1), 1)
    np.testing.assert_allclose(np.cross(line, motion.positions["left_hip"]), 0, atol=1e-12)


def test_facing_turns_the_x_axis_to_the_hip_line(motion):
    across = motion.facing()[:, :, 0]
    np.testing.assert_allclose(across[:, 1], 0)
    azimuth = np.rad2deg(np.arctan2(-across[:, 2], across[:, 0])) % 360
    np.testing.assert_allclose(azimuth, [0, 90, 200], atol=1e-9)


def test_frames_can_be_cut_out(motion):
    assert len(motion) == 3
    part = motion[1:]
    assert len(part) == 2
    np.testing.assert_array_equal(part.rotations["root"], motion.rotations["root"][1:])
