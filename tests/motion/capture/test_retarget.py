import warnings

import numpy as np
import pytest

from silpose.core import skeleton
from silpose.core.pose_space import wrap_degrees
from silpose.core.skeleton import ANGLES, LIMBS
from silpose.motion import MotionFolder
from silpose.motion.capture.bvh import bvh_joints, read_bvh, source_motion
from silpose.motion.capture.joint_names import common_names


def directions(points, names, start, end):
    bone = points[:, names[end]] - points[:, names[start]]
    return bone / np.linalg.norm(bone, axis=1, keepdims=True)


def our_directions(motion, start, end):
    points, _ = skeleton.forward_kinematics(skeleton.rotations_from_angles(motion.angles))
    return directions(points, {n: p for p, n in enumerate(skeleton.POINTS)}, start, end)


def test_known_angles(tmp_path, small_bvh):
    pose = {"root": (0, 30, 0), "left_hip": (0, 0, -25), "left_knee": (0, 0, 40),
            "right_knee": (0, 0, 10), "chest": (0, 0, 5), "head": (0, 20, 0)}  # fmt: skip
    small_bvh([pose] * 3).write(tmp_path / "pose.bvh")
    angles = dict(zip(ANGLES, MotionFolder(tmp_path).takes()[0].angles[0], strict=True))
    expected = {"root_y": 30, "left_hip_x": -25, "left_knee_x": 40, "right_knee_x": 10,
                "chest_x": 5, "head_y": 20}  # fmt: skip
    arms = ("shoulder", "elbow", "wrist")
    for name, angle in angles.items():
        if not any(arm in name for arm in arms):
            assert angle == pytest.approx(expected.get(name, 0), abs=1e-3), name


def test_arms_point_where_the_source_points(tmp_path, small_bvh):
    down = {"left_shoulder": (-80, 0, 0), "right_shoulder": (80, 0, 0), "left_elbow": (0, -90, 0)}
    small_bvh([down] * 3).write(tmp_path / "arms.bvh")
    motion = MotionFolder(tmp_path).takes()[0]
    c, s = np.cos(np.deg2rad(80)), np.sin(np.deg2rad(80))
    for start, end, expected in [
        ("left_shoulder", "left_elbow", (c, -s, 0)),
        ("right_shoulder", "right_elbow", (-c, -s, 0)),
        ("left_elbow", "left_wrist", (0, 0, 1)),
        ("right_wrist", "right_hand", (-c, -s, 0)),
    ]:
        np.testing.assert_allclose(our_directions(motion, start, end)[0], expected, atol=1e-6)


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


def test_scale_and_ground(tmp_path, small_bvh):
    frames = [{"left_hip": (0, 0, -20), "position": (0, 45, 10 * f)} for f in range(4)]
    small_bvh(frames).write(tmp_path / "glide.bvh")
    motion = MotionFolder(tmp_path, frames_per_second=30).takes()[0]
    np.testing.assert_allclose(np.diff(motion.root_position[:, 2]), 0.2, rtol=1e-5)
    rotations = skeleton.rotations_from_angles(motion.angles)
    np.testing.assert_allclose(
        motion.root_position[:, 1], skeleton.standing_height(rotations), atol=1e-6
    )


@pytest.mark.parametrize("drop", [(-0.26, -0.26), (0.0, -0.3)])
def test_any_rest_pose_with_arms_in_the_frontal_plane_will_do(tmp_path, small_bvh, drop):
    aside, down = drop
    arms = {
        f"{side}_{joint}": (-sign * aside, down, 0.0)
        for side, sign in (("left", 1), ("right", -1))
        for joint in ("elbow", "wrist")
    }
    small_bvh([{}, {"left_hip": (0, 0, -30)}], offsets=arms).write(tmp_path / "a_pose.bvh")
    motion = MotionFolder(tmp_path, frames_per_second=30).takes()[0]
    for sign, side in ((1, "left"), (-1, "right")):
        found = our_directions(motion, f"{side}_shoulder", f"{side}_elbow")[0]
        expected = np.array([-sign * aside, down, 0.0]) / np.hypot(aside, down)
        np.testing.assert_allclose(found, expected, atol=1e-6)
    hip = ANGLES.index("left_hip_x")
    np.testing.assert_allclose(motion.angles[:, hip], [0, -30], atol=0.01)


@pytest.mark.filterwarnings("ignore:.*singularity")  # the wrists of such arms
def test_without_a_rest_pose_bending_tells_the_hinges(tmp_path, small_bvh):
    """Every joint of the source is turned about by a rotation of its own, as in cmu69/."""
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
@pytest.mark.parametrize("kind", ["snu", "cmu", "cmu69"])
def test_limbs_and_heading_of_real_motion(shared_mocap, kind):
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # nothing is left out, nothing comes near a singularity
        takes = MotionFolder(shared_mocap / kind).takes()
    assert len(takes) == len(list((shared_mocap / kind).glob("*.bvh")))
    for motion in takes:
        bvh = read_bvh(shared_mocap / kind / f"{motion.name}.bvh")
        joints = bvh_joints(bvh, common_names(), motion.name)
        if kind == "cmu" or motion.name == "wd2_freeWalk_01":
            bvh = bvh[1:]  # the T-pose
        source = source_motion(bvh.resample(15.0), joints)
        for start, end in LIMBS.items():
            cosine = np.sum(source.direction(start, end) * our_directions(motion, start, end), 1)
            assert np.rad2deg(np.arccos(np.minimum(cosine, 1.0))).mean() < 3.0, (motion.name, end)
        hips = source.direction("right_hip", "left_hip")
        azimuth = np.rad2deg(np.arctan2(-hips[:, 2], hips[:, 0]))
        assert np.abs(wrap_degrees(azimuth - motion.angles[:, 0])).max() < 2.0, motion.name
        assert np.abs(np.diff(motion.angles[:, 1:], axis=0)).max() < 180.0, motion.name


@pytest.mark.shared
def test_the_motion_alone_tells_the_legs_rest_pose(shared_mocap, monkeypatch):
    """Where a file has a T-pose, both ways agree about the legs, but for the pelvis' tilt."""
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


@pytest.mark.shared
@pytest.mark.parametrize("kind", ["snu", "cmu", "cmu69"])
def test_soles_are_level_in_stance(shared_mocap, kind):
    pitches = []
    for motion in MotionFolder(shared_mocap / kind).takes():
        points, turned = skeleton.forward_kinematics(skeleton.rotations_from_angles(motion.angles))
        points = points + motion.root_position[:, None]
        left, right = (skeleton.JOINTS.index(f"{side}_ankle") for side in ("left", "right"))
        speed = np.linalg.norm(np.gradient(points[:, [left, right]], axis=0), axis=2) * 15
        for foot, alone in ((left, speed[:, 0] < 0.25), (right, speed[:, 1] < 0.25)):
            alone = alone & (speed.max(axis=1) > 0.6)
            pitches.extend(np.rad2deg(np.arcsin(turned[alone, foot, 1, 2])))
    assert abs(np.median(pitches)) < 1.5
