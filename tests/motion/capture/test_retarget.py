from functools import cache

import numpy as np
import pytest

from silpose.core import skeleton
from silpose.core.pose_space import wrap_degrees
from silpose.core.skeleton import ANGLES, LIMBS, near_singularity
from silpose.motion import MotionFolder


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


@pytest.mark.filterwarnings("ignore:.*feet slide")  # its legs do not move
def test_scale_and_ground(tmp_path, small_bvh):
    frames = [{"left_hip": (0, 0, -20), "position": (0, 45, 10 * f)} for f in range(4)]
    small_bvh(frames).write(tmp_path / "glide.bvh")
    motion = MotionFolder(tmp_path, frames_per_second=30).takes()[0]
    np.testing.assert_allclose(np.diff(motion.root_position[:, 2]), 0.2, rtol=1e-5)
    rotations = skeleton.rotations_from_angles(motion.angles)
    np.testing.assert_allclose(
        motion.root_position[:, 1], skeleton.standing_height(rotations), atol=1e-6
    )


@pytest.fixture(scope="module")
def captured(shared_mocap):
    """Give all takes of a folder, each read once."""

    @cache
    def read(kind):
        folder = MotionFolder(shared_mocap / kind)
        return [folder.captured(file) for file in folder.files()]

    return read


@pytest.mark.shared
@pytest.mark.parametrize("kind", ["snu", "cmu", "cmu69"])
def test_limbs_and_heading_of_real_motion(captured, kind):
    for take in captured(kind):
        name, source = take.report.file, take.source
        for start, end in LIMBS.items():
            cosine = np.sum(source.direction(start, end) * our_directions(take, start, end), 1)
            assert np.rad2deg(np.arccos(np.minimum(cosine, 1.0))).mean() < 3.0, (name, end)
        hips = source.direction("right_hip", "left_hip")
        azimuth = np.rad2deg(np.arctan2(-hips[:, 2], hips[:, 0]))
        assert np.abs(wrap_degrees(azimuth - take.angles[:, 0])).max() < 2.0, name
        assert np.abs(np.diff(take.angles[:, 1:], axis=0)).max() < 180.0, name
        assert not near_singularity(take.angles), name


@pytest.mark.shared
@pytest.mark.parametrize("kind", ["snu", "cmu", "cmu69"])
def test_nothing_is_doubted_in_real_motion(captured, kind):
    for take in captured(kind):
        report = take.report
        if report.file.endswith("wd2_freeWalk_01.bvh"):  # the performer takes up a T-pose first
            assert "first 20 frames are a T-pose" in report.notes[0]
        else:
            assert report.notes == ()
        assert (report.up, report.facing, report.mirrored) == ("y", "knees and feet", False)


@pytest.mark.shared
@pytest.mark.parametrize("kind", ["snu", "cmu", "cmu69"])
def test_soles_are_level_in_stance(captured, kind):
    pitches = []
    for take in captured(kind):
        points, turned = skeleton.forward_kinematics(skeleton.rotations_from_angles(take.angles))
        points = points + take.root_position[:, None]
        left, right = (skeleton.JOINTS.index(f"{side}_ankle") for side in ("left", "right"))
        speed = np.linalg.norm(np.gradient(points[:, [left, right]], axis=0), axis=2) * 15
        for foot, alone in ((left, speed[:, 0] < 0.25), (right, speed[:, 1] < 0.25)):
            alone = alone & (speed.max(axis=1) > 0.6)
            pitches.extend(np.rad2deg(np.arcsin(turned[alone, foot, 1, 2])))
    assert abs(np.median(pitches)) < 1.5
