import cv2
import numpy as np

from silpose.core.pose_space import ANGLES
from silpose.fitting.geometry import geometry_of
from silpose.fitting.kinematics import pose_tree
from silpose.fitting.outline import outline_of


def test_points_lie_on_the_contour_of_the_rendered_mask(body, camera, walk, view):
    x, masks = walk
    geometry = geometry_of(body)
    for pose, mask in zip(np.deg2rad(ANGLES.angles(x)), masks, strict=True):
        rotations, positions, _ = pose_tree(pose, geometry)
        outline = outline_of(rotations, positions, np.zeros(3), geometry, view)
        inside = cv2.distanceTransform(mask, cv2.DIST_L2, 5)
        outside = cv2.distanceTransform(1 - mask, cv2.DIST_L2, 5)
        columns, rows = np.rint(outline.pixels).astype(int).T
        assert np.quantile(np.maximum(inside, outside)[rows, columns], 0.99) < 4
        ahead = np.rint(outline.pixels + 3 * outline.normals).astype(int)
        assert mask[ahead[:, 1], ahead[:, 0]].mean() < 0.2


def test_no_part_of_the_contour_is_missed(body, walk, view):
    x, masks = walk
    geometry = geometry_of(body)
    rotations, positions, _ = pose_tree(np.deg2rad(ANGLES.angles(x[0])), geometry)
    outline = outline_of(rotations, positions, np.zeros(3), geometry, view)
    (contour,), _ = cv2.findContours(masks[0], cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    apart = np.linalg.norm(contour[:, 0][:, None] - outline.pixels[None], axis=2).min(axis=1)
    assert apart.max() < 4
