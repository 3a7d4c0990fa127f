import numpy as np
import pytest

from silpose.core import skeleton
from silpose.core.skeleton import ANGLES
from silpose.motion import MotionFolder


def limb_directions(motion, start, end):
    points, _ = skeleton.forward_kinematics(skeleton.rotations_from_angles(motion.angles))
    bone = points[:, skeleton.POINTS.index(end)] - points[:, skeleton.POINTS.index(start)]
    return bone / np.linalg.norm(bone, axis=1, keepdims=True)


def test_first_frame_t_pose_is_dropped(tmp_path, small_bvh):
    walk = [{"left_hip": (0, 0, -30)}] * 4
    small_bvh([{}, *walk]).write(tmp_path / "t_first.bvh")
    motion = MotionFolder(tmp_path, frames_per_second=30).takes()[0]
    assert len(motion) == 4
    np.testing.assert_allclose(motion.angles[:, ANGLES.index("left_hip_x")], -30, atol=1e-6)


def test_a_t_pose_may_face_anywhere(tmp_path, small_bvh):
    turned = {"root": (0, 90, 0)}
    small_bvh([turned, turned | {"left_hip": (0, 0, -30)}]).write(tmp_path / "aside.bvh")
    angles = MotionFolder(tmp_path).takes()[0].angles[0]
    assert angles[0] == pytest.approx(90, abs=1e-6)
    assert angles[ANGLES.index("left_hip_x")] == pytest.approx(-30, abs=1e-6)


@pytest.mark.parametrize("drop", [(-0.26, -0.26), (0.0, -0.3)])
def test_a_rest_pose_may_have_its_arms_anywhere_in_the_frontal_plane(tmp_path, small_bvh, drop):
    aside, down = drop
    arms = {
        f"{side}_{joint}": (-sign * aside, down, 0.0)
        for side, sign in (("left", 1), ("right", -1))
        for joint in ("elbow", "wrist")
    }
    small_bvh([{}, {"left_hip": (0, 0, -30)}], offsets=arms).write(tmp_path / "a_pose.bvh")
    motion = MotionFolder(tmp_path, frames_per_second=30).takes()[0]
    for sign, side in ((1, "left"), (-1, "right")):
        found = limb_directions(motion, f"{side}_shoulder", f"{side}_elbow")[0]
        expected = np.array([-sign * aside, down, 0.0]) / np.hypot(aside, down)
        np.testing.assert_allclose(found, expected, atol=1e-6)
    hip = ANGLES.index("left_hip_x")
    np.testing.assert_allclose(motion.angles[:, hip], [0, -30], atol=0.01)


@pytest.mark.filterwarnings("ignore:.*singularity")  # the wrists of such arms
def test_without_a_rest_pose_hinges_follow_from_bending(tmp_path, small_bvh):
    """The source's shoulders have axes of their own, as in the folder cmu69."""
    swing = 25 * np.sin(np.arange(60) / 5)
    knee = 30 + 30 * np.cos(np.arange(60) / 5)
    walk = [
        {"left_hip": (0, 0, s), "right_hip": (0, 0, -s), "left_knee": (0, 0, k),
         "right_knee": (0, 0, 60 - k), "left_shoulder": (-70, 0, 0), "right_shoulder": (70, 0, 0),
         "left_elbow": (0, -k, 0), "right_elbow": (0, k, 0)}
        for s, k in zip(swing, knee, strict=True)
    ]  # fmt: skip
    forward = {
        f"{side}_{j}": (0, 0, 0.26) for side in ("left", "right") for j in ("elbow", "wrist")
    }
    forward |= {
        f"{side}_{j}": (0, -0.4, 0) for side in ("left", "right") for j in ("knee", "ankle")
    }
    plain = small_bvh(walk, offsets={k: v for k, v in forward.items() if v[1]})
    plain.write(tmp_path / "plain" / "a.bvh")
    odd = small_bvh(
        [w | {"left_shoulder": (0, 70, -90), "right_shoulder": (0, -70, -90)} for w in walk],
        offsets=forward,
    )
    odd.write(tmp_path / "odd" / "a.bvh")
    (expected,), (found,) = (MotionFolder(tmp_path / k).takes() for k in ("plain", "odd"))
    legs = [k for k, name in enumerate(ANGLES) if "hip" in name or "knee" in name]
    assert np.abs(found.angles[:, legs] - expected.angles[:, legs]).max() < 1.0


@pytest.mark.shared
def test_the_legs_rest_pose_follows_from_the_motion_alone(shared_mocap, monkeypatch):
    """Where a file has a T-pose, both ways agree about the legs, apart from the pelvis' tilt."""
    root = shared_mocap / "snu"
    known = MotionFolder(root).takes()
    monkeypatch.setattr("silpose.motion.capture.rest_pose._is_rest_pose", lambda pose: False)
    monkeypatch.setattr("silpose.motion.capture.rest_pose._is_t_pose", lambda pose: False)
    for one, other in zip(known, MotionFolder(root).takes(), strict=True):
        if "spiral" not in one.name:
            continue
        off = np.abs((one.angles - other.angles).mean(axis=0))
        for name in ("left_hip_z", "right_hip_z", "left_knee_x", "right_knee_x"):
            assert off[ANGLES.index(name)] < 2.0, (one.name, name)
