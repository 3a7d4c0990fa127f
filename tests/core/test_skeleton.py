import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mannequin import Mannequin

from silpose.core import skeleton

SMPLX = {
    "root": "Pelvis", "chest": "Spine3", "neck": "Neck", "head": "Head",
    "collar": "Collar", "shoulder": "Shoulder", "elbow": "Elbow", "wrist": "Wrist",
    "hip": "Hip", "knee": "Knee", "ankle": "Ankle", "toes": "Foot",
}  # fmt: skip


def smplx_name(joint):
    side, _, rest = joint.partition("_")
    return f"{side[0].upper()}_{SMPLX[rest]}" if rest else SMPLX[joint]


def zero_pose():
    return skeleton.rotations_from_angles(np.zeros((1, 54)))


def test_zero_pose_is_the_mannequins_rest():
    body = Mannequin("convex", lod=1)
    rest = body.joint_transforms(body.rest_pose())[:, :3, 3]
    positions, _ = skeleton.forward_kinematics(zero_pose())
    named = [*skeleton.JOINTS, "left_toes", "right_toes"]
    for name in named:
        expected = rest[body.joint_index(smplx_name(name))] - rest[0]
        np.testing.assert_allclose(positions[0, skeleton.POINTS.index(name)], expected, atol=1e-4)


@given(st.integers(0, 2**32 - 1))
def test_angles_survive_the_way_through_rotations(seed):
    angles = np.random.default_rng(seed).uniform(-85, 85, (3, 54))
    there = skeleton.rotations_from_angles(angles)
    np.testing.assert_allclose(skeleton.angles_from_rotations(there), angles, atol=1e-6)


@pytest.mark.parametrize("theta", [-170.0, -90.0, 0.0, 35.0, 90.0])
def test_heading_is_the_azimuth_of_the_hip_line(theta):
    angles = np.random.default_rng(1).uniform(-40, 40, (1, 54))
    angles[0, 0] = theta
    root = skeleton.rotations_from_angles(angles)[0, 0]
    across = root[:, 0]  # the root's x axis, towards the left hip
    assert np.rad2deg(np.arctan2(-across[2], across[0])) == pytest.approx(theta)


def test_positive_heading_turns_towards_the_own_left():
    angles = np.zeros((1, 54))
    angles[0, 0] = 90
    facing = skeleton.rotations_from_angles(angles)[0, 0] @ [0, 0, 1]
    np.testing.assert_allclose(facing, [1, 0, 0], atol=1e-12)  # the left hip is on +X


@pytest.mark.parametrize(
    ("angle", "point", "axis", "sign"),
    [
        ("left_hip_x", "left_knee", 2, +1),  # flexing a hip (negative x) brings the knee forward
        ("left_knee_x", "left_ankle", 2, -1),  # flexing a knee (positive x) brings the foot back
        ("left_elbow_y", "left_wrist", 2, +1),  # flexing an elbow brings the hand forward
        ("right_elbow_y", "right_wrist", 2, +1),
    ],
)
def test_flexion_goes_the_way_a_body_bends(angle, point, axis, sign):
    flexion = {"left_hip_x": -40, "left_knee_x": 40, "left_elbow_y": -40, "right_elbow_y": 40}
    angles = np.zeros((1, 54))
    angles[0, skeleton.ANGLES.index(angle)] = flexion[angle]
    p = skeleton.POINTS.index(point)
    bent = skeleton.forward_kinematics(skeleton.rotations_from_angles(angles))[0][0, p]
    rest = skeleton.forward_kinematics(zero_pose())[0][0, p]
    assert sign * (bent - rest)[axis] > 0.05


def test_bone_lengths_do_not_depend_on_the_pose():
    angles = np.random.default_rng(2).uniform(-80, 80, (20, 54))
    positions, _ = skeleton.forward_kinematics(skeleton.rotations_from_angles(angles))
    bones = [b for b in skeleton.BONES if skeleton.POINTS[b[1]] != "chest"]  # the spine bends
    lengths = np.stack(
        [np.linalg.norm(positions[:, b] - positions[:, a], axis=1) for a, b in bones]
    )
    np.testing.assert_allclose(lengths, lengths[:, :1].repeat(20, axis=1), atol=1e-12)


def test_chest_bends_as_the_mannequins_spine_does():
    body = Mannequin("convex", lod=2)
    angles = np.zeros((1, 54))
    chest = slice(3, 6)
    angles[0, chest] = [30, -20, 15]
    rotations = skeleton.rotations_from_angles(angles)
    pose = body.rest_pose(batch_dims=(1,))
    from scipy.spatial.transform import Rotation

    third = Rotation.from_matrix(skeleton.spine_thirds(rotations[:, 1])).as_rotvec()
    for spine in (2, 5, 8):
        pose["body_pose"][:, spine] = third
    placed = body.joint_transforms(pose)[0, :, :3, 3]
    ours = skeleton.forward_kinematics(rotations)[0][0]
    for joint in ("chest", "neck", "left_wrist"):
        theirs = placed[body.joint_index(smplx_name(joint))] - placed[0]
        np.testing.assert_allclose(ours[skeleton.POINTS.index(joint)], theirs, atol=2e-4)


def test_standing_height_puts_the_lowest_sole_on_the_ground():
    upright = skeleton.standing_height(zero_pose())[0]
    assert upright == pytest.approx(0.95, abs=0.01)
    angles = np.zeros((1, 54))
    angles[0, [skeleton.ANGLES.index(f"{s}_hip_x") for s in ("left", "right")]] = -90  # sitting
    sitting = skeleton.standing_height(skeleton.rotations_from_angles(angles))[0]
    assert 0.1 < sitting < 0.7 * upright


def test_rotations_relative_to_the_parent_come_from_those_in_the_world():
    angles = np.random.default_rng(3).uniform(-80, 80, (4, 54))
    rotations = skeleton.rotations_from_angles(angles)
    _, world = skeleton.forward_kinematics(rotations)
    by_joint = dict(zip(skeleton.JOINTS, np.moveaxis(world, 1, 0), strict=True))
    np.testing.assert_allclose(skeleton.local_rotations(by_joint), rotations, atol=1e-12)


def test_the_smallest_rotation_turns_about_the_normal():
    start, end = np.array([2.0, 0, 0]), np.array([1.0, 0, 3.0])
    rotation = skeleton.smallest_rotation(start, end)
    np.testing.assert_allclose(rotation @ start / 2, end / np.linalg.norm(end), atol=1e-12)
    np.testing.assert_allclose(rotation @ [0, 1, 0], [0, 1, 0], atol=1e-12)
    np.testing.assert_array_equal(skeleton.smallest_rotation(start, 3 * start), np.eye(3))


def test_frames_near_a_singularity_are_counted_by_joint():
    angles = np.zeros((5, 54))
    angles[1:3, skeleton.ANGLES.index("left_hip_z")] = 85, -89
    assert skeleton.near_singularity(angles) == {"left_hip": 2}


def test_the_other_side_of_the_middle_is_itself():
    assert skeleton.other_side("left_knee") == "right_knee"
    assert skeleton.other_side("neck") == "neck"
