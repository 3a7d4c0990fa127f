import numpy as np
import pytest
from walk_files import WalkFile

from silpose.motion.capture.formats import read_raw
from silpose.motion.capture.source_motion import SourceMotion, source_motion, unit


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


def test_a_reflection_leaves_rotations_rotations(walking):
    motion = walking()
    reflected = motion.transformed(np.diag([-1.0, 1, 1]))
    for joint, turned in reflected.rotations.items():
        np.testing.assert_allclose(np.linalg.det(turned), 1), joint
    again = reflected.transformed(np.diag([-1.0, 1, 1]))
    np.testing.assert_allclose(again.rotations["left_knee"], motion.rotations["left_knee"])


def test_lengths_are_scaled(walking):
    motion = walking()
    assert motion.scaled(100).leg_length() == pytest.approx(100 * motion.leg_length())


def test_spine_and_toes_are_found_in_the_tree(tmp_path):
    walk = WalkFile(unit=1.0)
    raw = read_raw(walk.write(tmp_path / "a.bvh"))
    nodes = {walk.name_of(j): j for j in walk.joints() if "/end" not in j}
    ours = {nodes[name]: n for n, name in enumerate(raw.names) if name in nodes}
    given = {j: n for j, n in ours.items() if j not in ("spine", "spine1") and "toes" not in j}
    motion = source_motion(raw, given)
    np.testing.assert_array_equal(motion.positions["spine"], raw.positions[:, ours["spine"]])
    toes = motion.direction("left_ankle", "left_toes")
    assert np.all(np.sum(toes * motion.facing()[:, :, 2], axis=1) > 0)
    assert "spine" not in motion.rotations and "left_toes" not in motion.rotations


def test_a_vector_of_no_length_stays():
    np.testing.assert_array_equal(unit(np.zeros((2, 3))), np.zeros((2, 3)))
