import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from silpose.motion.capture.formats.bvh.channels import euler_matrices, local_motion
from silpose.motion.capture.formats.bvh.hierarchy import Node

XYZ = ["xp", "yp", "zp"]


def node(name, parent, channels, offset):
    return Node(name, parent, 1, channels=channels, offset=offset)


@pytest.mark.parametrize("axes", ["zxy", "xyz", "yxz", "xyx", "z"])
def test_turns_are_about_the_joints_own_axes(axes):
    degrees = np.random.default_rng(0).uniform(-180, 180, (5, len(axes)))
    expected = Rotation.from_euler(axes.upper(), degrees, degrees=True).as_matrix()
    np.testing.assert_allclose(euler_matrices(axes, degrees).reshape(-1, 3, 3), expected)


def test_more_turns_than_three():
    np.testing.assert_allclose(euler_matrices("xyzzyx", [[1, 2, 3, -3, -2, -1]] * np.ones((2, 6))),
                               np.tile(np.eye(3), (2, 1, 1)), atol=1e-12)  # fmt: skip


def test_channels_in_any_number_and_order():
    nodes = [
        node("a", -1, ["zr", "yp", "xr"], (1.0, 2.0, 3.0)),
        node("b", 0, [], (0.0, 1.0, 0.0)),
        node("c", 1, ["yr"], (0.0, 1.0, 0.0)),
    ]
    rotations, positions, offsets, notes = local_motion(nodes, np.array([[90.0, 7, 30, 45]]))
    np.testing.assert_allclose(positions[0], [(1, 7, 3), (0, 1, 0), (0, 1, 0)])
    expected = [
        Rotation.from_euler("ZX", (90, 30), degrees=True).as_matrix(),
        np.eye(3),
        Rotation.from_euler("Y", 45, degrees=True).as_matrix(),
    ]
    np.testing.assert_allclose(rotations[0], expected)
    np.testing.assert_allclose(offsets[1], (0, 1, 0))
    assert notes == ()


def test_positions_of_inner_joints_replace_the_offset():
    nodes = [node("a", -1, XYZ, (9.0, 9, 9)), node("b", 0, XYZ, (0.0, 0, 0))]
    values = np.array([[0.0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 1.1, 0], [0, 0, 0, 0, 5, 0]])
    _, positions, offsets, notes = local_motion(nodes, values)
    np.testing.assert_allclose(positions[:, 1, 1], [1, 1.1, 5])
    np.testing.assert_allclose(offsets[1], (0, 1.1, 0))
    assert notes == ()


def test_positions_that_are_all_zero_are_movements():
    offsets = [(0.0, 0, 0), (0.0, 1, 0), (0.0, 2, 0), (3.0, 0, 0)]
    nodes = [
        node(name, p, XYZ, offset)
        for name, p, offset in zip("abcd", range(-1, 3), offsets, strict=True)
    ]
    values = np.zeros((4, 12))
    values[:, 4] = [0, 0.1, 0.2, 0.1]
    _, positions, _, notes = local_motion(nodes, values)
    np.testing.assert_allclose(positions[:, 1, 1], [1, 1.1, 1.2, 1.1])
    np.testing.assert_allclose(positions[:, 3, 0], 3)
    assert "movements from their OFFSET" in notes[0]


def test_the_hips_may_stay_at_the_root():
    nodes = [node("a", -1, XYZ, (0.0, 0, 0)), node("b", 0, XYZ, (0.0, 95, 0))]
    _, positions, _, notes = local_motion(nodes, np.zeros((4, 6)))
    np.testing.assert_allclose(positions, 0.0)
    assert notes == ()


def test_scales():
    nodes = [node("a", -1, ["xs", "xr"], (0.0, 0, 0))]
    assert local_motion(nodes, np.array([[1.0, 50]] * 2))[3] == ()
    assert "scales" in local_motion(nodes, np.array([[2.0, 50]] * 2))[3][0]
