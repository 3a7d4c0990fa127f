import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.motion import MotionFolder


def refusal(folder):
    """The message with which the only file of a folder is refused."""
    with pytest.raises(InputError) as error:
        MotionFolder(folder).takes()
    return str(error.value)


@pytest.mark.parametrize("content", ["", "hello\n", "PK\x03\x04\x00\xff", "HIERARCHY\n"])
def test_no_bvh(tmp_path, content):
    (tmp_path / "odd.bvh").write_text(content)
    message = refusal(tmp_path)
    assert "odd.bvh" in message and "no BVH file" in message


@pytest.mark.parametrize("share", [0.1, 0.3, 0.5, 0.7, 0.9, 0.97])
def test_truncated(tmp_path, small_bvh, share):
    text = small_bvh([{}] * 20).text()
    (tmp_path / "cut.bvh").write_text(text[: int(share * len(text))])
    message = refusal(tmp_path)
    assert "cut.bvh" in message and "truncated" in message


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("CHANNELS 3 ", "CHANNELS 4 "),
        ("CHANNELS 3 Zrotation Yrotation", "CHANNELS 2 Zrotation"),
        ("CHANNELS 6 Xposition", "CHANNELS 5"),
        ("0.0 45.0", "0.0"),
        ("OFFSET", "OFFSET one"),
        ("JOINT Spine1", "JOINT"),
    ],
)
def test_wrong_counts(tmp_path, small_bvh, right, wrong):
    (tmp_path / "odd.bvh").write_text(small_bvh().text().replace(right, wrong, 1))
    assert "odd.bvh: cannot be read as BVH" in refusal(tmp_path)


def test_unknown_joints(tmp_path, small_bvh):
    small_bvh(names={"left_elbow": "LeftTentacle"}).write(tmp_path / "squid.bvh")
    message = refusal(tmp_path)
    assert "squid.bvh: cannot find left_elbow (LeftForeArm or" in message
    assert "LeftTentacle" in message and "motion.joints={left_elbow: [NAME]}" in message


def test_two_joints_of_one_name(tmp_path, small_bvh):
    small_bvh(names={"left_knee": "Knee", "right_knee": "Knee"}).write(tmp_path / "twins.bvh")
    assert "twins.bvh" in refusal(tmp_path)


def test_other_names_can_be_given(tmp_path, small_bvh):
    small_bvh(names={"left_elbow": "Tentacle"}).write(tmp_path / "squid.bvh")
    assert len(MotionFolder(tmp_path, joints={"left_elbow": ["tentacle"]}).takes()) == 1
    with pytest.raises(InputError, match=r"motion\.joints has no joint 'tentacle'; joints"):
        MotionFolder(tmp_path, joints={"tentacle": ["left_elbow"]})


def test_no_frames(tmp_path, small_bvh):
    small_bvh(frames=()).write(tmp_path / "still.bvh")
    assert "no motion frames" in refusal(tmp_path)


def test_only_the_t_pose(tmp_path, small_bvh):
    small_bvh(frames=({},)).write(tmp_path / "t.bvh")
    assert "only frame is the T-pose" in refusal(tmp_path)


@pytest.mark.parametrize("bad", ["nan", "inf", "1e30"])
@pytest.mark.parametrize("what", ["head", "position"])
def test_numbers_not_plausible(tmp_path, small_bvh, bad, what):
    file = small_bvh([{}, {}, {what: (0, bad, 0)}]).write(tmp_path / "hole.bvh")
    message = refusal(tmp_path)
    line = next(n for n, row in enumerate(file.read_text().split("\n"), start=1) if bad in row)
    assert f"hole.bvh: frame 2, line {line}, holds a" in message


def test_huge_offset(tmp_path, small_bvh):
    small_bvh(offsets={"head": (0, 1e9, 0)}).write(tmp_path / "giraffe.bvh")
    assert "the OFFSET of 'Head'" in refusal(tmp_path)


def test_legs_without_length(tmp_path, small_bvh):
    legs = {f"{side}_{j}": (0, 0, 0) for side in ("left", "right") for j in ("knee", "ankle")}
    small_bvh(offsets=legs).write(tmp_path / "ghost.bvh")
    assert "legs have no length" in refusal(tmp_path)


@pytest.mark.parametrize("frame_time", ["0", "-0.033", "nan", "inf", "fast", "1e-30", "1e9"])
def test_frame_time(tmp_path, small_bvh, frame_time):
    small_bvh(frame_time=frame_time).write(tmp_path / "clock.bvh")
    message = refusal(tmp_path)
    assert "clock.bvh: line" in message and "frame time" in message


def test_lying_people_without_a_rest_pose_are_refused(tmp_path, small_bvh):
    lying = {"root": (0, 0, 90), "left_shoulder": (0, 60, 0)}
    forward = {"left_elbow": (0, 0, 0.26), "right_elbow": (0, 0, 0.26)}  # no rest pose
    small_bvh([lying] * 3, offsets=forward).write(tmp_path / "z_up.bvh")
    assert "+Y up" in refusal(tmp_path)


@pytest.mark.parametrize(
    "naming",
    [
        lambda name: f"mixamorig:{name}",
        lambda name: f"Bip01 {name}".replace(" ", "_"),
        str.upper,
        lambda name: name.replace("Left", "L_").replace("Right", "R_"),
    ],
)
def test_spellings_do_not_matter(tmp_path, small_bvh, naming):
    plain = small_bvh().names | {"left_hip": "LeftThigh", "right_hip": "RightThigh",
                     "left_knee": "LeftCalf", "right_knee": "RightCalf",
                     "left_collar": "LeftClavicle", "right_collar": "RightClavicle",
                     "left_shoulder": "LeftUpperArm",
                     "right_shoulder": "RightUpperArm"}  # fmt: skip
    pose = [{"left_hip": (0, 0, -20), "right_elbow": (0, 30, 0)}] * 3
    small_bvh(pose, names={k: naming(v) for k, v in plain.items()}).write(tmp_path / "a.bvh")
    small_bvh(pose).write(tmp_path / "b.bvh")
    one, other = MotionFolder(tmp_path).takes()
    np.testing.assert_allclose(one.angles, other.angles, atol=1e-9)


def test_a_skeleton_may_lack_collars_neck_and_chest(tmp_path, small_bvh):
    small_bvh(names={"neck": "x1", "left_collar": "x2", "right_collar": "x3", "chest": "x4"}).write(
        tmp_path / "plain.bvh"
    )
    (take,) = MotionFolder(tmp_path).takes()
    assert np.isfinite(take.angles).all()
