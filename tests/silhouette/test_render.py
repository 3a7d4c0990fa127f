import cv2
import numpy as np

from silpose.core import skeleton
from silpose.core.pose_space import ANGLES
from silpose.silhouette import Camera, render


def pose(**angles):
    values = np.zeros((1, 54))
    for name, angle in angles.items():
        values[0, skeleton.ANGLES.index(name)] = angle
    return ANGLES.rotations(ANGLES.from_angles(values))


def mask_of(body, camera, rotations, offset=None):
    (mask,) = render(body, camera, rotations, offset)
    return mask


def overlap(a, b):
    return (a & b).sum() / (a | b).sum()


def test_mask_holds_every_projected_joint(body):
    camera = Camera()
    angles = np.random.default_rng(0).uniform(-20, 20, (10, 54))
    rotations = skeleton.rotations_from_angles(angles)
    positions, _ = skeleton.forward_kinematics(rotations)
    for mask, joints in zip(render(body, camera, rotations), positions, strict=True):
        assert mask.dtype == np.uint8
        assert set(np.unique(mask)) == {0, 1}
        column, row = np.rint(camera.project(joints[: len(skeleton.JOINTS)])).astype(int).T
        inside = [
            mask[r - 1 : r + 2, c - 1 : c + 2].any() for r, c in zip(row, column, strict=True)
        ]
        assert all(inside)


def test_the_left_arm_is_on_the_right_of_the_image_when_facing_the_camera(body):
    raised = mask_of(body, Camera(), pose(left_shoulder_z=70, right_shoulder_z=70))
    _, columns = np.nonzero(raised[:60])  # only the raised arm and the head reach up there
    assert columns.max() > 128 + 20
    assert columns.min() > 128 - 20


def test_turning_by_180_mirrors_a_frontal_silhouette(body):
    front = mask_of(body, Camera(elevation=0, distance=50, focal_length=22), pose())
    back = mask_of(body, Camera(elevation=0, distance=50, focal_length=22), pose(root_y=180))
    assert overlap(front, back[:, ::-1]) > 0.98


def test_pieces_fill_as_the_surfaces_triangles_do(body):
    camera = Camera()
    rotations = pose(left_knee_x=40, chest_x=20)
    slow = np.zeros((256, 256), np.uint8)
    for triangle in camera.project(body.triangles(rotations)[0]):
        cv2.fillConvexPoly(slow, np.rint(triangle * 16).astype(np.int32), 1, cv2.LINE_8, 4)
    assert overlap(mask_of(body, camera, rotations), slow) > 0.995


def test_what_is_behind_the_camera_is_left_out(body):
    mask = mask_of(body, Camera(), pose(), np.array([[0.0, 0, 10]]))
    assert not mask.any()
