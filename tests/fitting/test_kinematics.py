import numpy as np
import pytest

from silpose.core.skeleton import rotations_from_angles
from silpose.fitting.geometry import geometry_of
from silpose.fitting.kinematics import pose_tree

ANGLES = np.deg2rad(np.random.default_rng(0).normal(0, 20, 54))


def posed(angles, geometry):
    rotations, positions, _ = pose_tree(angles, geometry)
    turned = geometry.points @ np.swapaxes(rotations[geometry.nodes], 1, 2)
    return turned + positions[geometry.nodes][:, None]


def test_links_are_where_the_renderer_has_them(body):
    pieces = body.pieces(rotations_from_angles(np.rad2deg(ANGLES)[None]))[0]
    assert posed(ANGLES, geometry_of(body)) == pytest.approx(pieces, abs=1e-5)


@pytest.mark.parametrize("angle", [0, 1, 2, 3, 4, 5, 17, 28, 40, 53])
def test_axes_are_the_derivatives_of_points(body, angle):
    geometry, step = geometry_of(body), 1e-6
    moved = ANGLES.copy()
    moved[angle] += step
    by_difference = (posed(moved, geometry) - posed(ANGLES, geometry)) / step
    _, positions, axes = pose_tree(ANGLES, geometry)
    points = posed(ANGLES, geometry)
    by_axes = np.zeros_like(points)
    for link, own in enumerate(geometry.nodes):
        for node in np.flatnonzero(geometry.ancestors[own]):
            if geometry.joints[node] == angle // 3:
                by_axes[link] += np.cross(axes[node, angle % 3], points[link] - positions[node])
    assert by_axes == pytest.approx(by_difference, abs=1e-5)
