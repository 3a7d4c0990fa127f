"""AMASS files are written here in its layout: there are none that may be shared."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from silpose.core import skeleton
from silpose.core.errors import InputError
from silpose.core.pose_space import wrap_degrees
from silpose.core.skeleton import LIMBS
from silpose.motion import MotionFolder

SMPL_PARENTS = (-1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 12, 13, 14, 16, 17, 18, 19)
SMPL = {"root": 0, "left_hip": 1, "right_hip": 2, "left_knee": 4, "right_knee": 5,
        "left_ankle": 7, "right_ankle": 8, "left_shoulder": 16, "right_shoulder": 17,
        "left_elbow": 18, "right_elbow": 19, "left_wrist": 20, "right_wrist": 21}  # fmt: skip


def takes(folder, **settings):
    return MotionFolder(folder, formats=["npz"], **settings).takes()


def upright(rng, frames):
    """Axis-angle (frames, 22, 3) of moderate poses that turn, +Z up."""
    turns = rng.normal(0, 0.25, (frames, 22, 3))
    heading = Rotation.from_euler("Z", np.linspace(0, 3, frames)[:, None])
    lean = Rotation.from_rotvec(0.2 * turns[:, 0])
    turns[:, 0] = (heading * Rotation.from_euler("X", 90, degrees=True) * lean).as_rotvec()
    return turns


@pytest.mark.parametrize("columns", [156, 165])
def test_limbs_point_where_smpls_forward_kinematics_says(tmp_path, small_amass, columns):
    turns = upright(np.random.default_rng(0), 31)
    small_amass(tmp_path / "a" / "walk_poses.npz", turns, rate=30.0, columns=columns)
    (take,) = takes(tmp_path, frames_per_second=30)
    world = [Rotation.from_rotvec(turns[:, 0])]
    for j in range(1, 22):
        world.append(world[SMPL_PARENTS[j]] * Rotation.from_rotvec(turns[:, j]))
    points, _ = skeleton.forward_kinematics(skeleton.rotations_from_angles(take.angles))
    ours = {name: points[:, p] for p, name in enumerate(skeleton.POINTS)}
    for start, end in LIMBS.items():
        expected = world[SMPL[start]].apply(skeleton.OFFSETS[end])[:, [0, 2, 1]] * [1, 1, -1]
        found = ours[end] - ours[start]
        cosine = np.sum(expected * found, axis=1) / np.linalg.norm(expected, axis=1) ** 2
        assert np.rad2deg(np.arccos(np.minimum(cosine, 1))).max() < 0.01, end
    x = world[0].as_matrix()[:, :, 0]  # of the pelvis, whose heading counts
    heading = np.rad2deg(np.arctan2(x[:, 1], x[:, 0]))
    assert np.abs(wrap_degrees(heading - take.angles[:, 0])).max() < 0.01


def test_resampled_and_on_the_ground(tmp_path, small_amass):
    trans = np.stack([np.arange(61) / 60, np.zeros(61), np.full(61, 7.0)], axis=1)
    turns = np.zeros((61, 22, 3))
    turns[:, 0, 0] = np.pi / 2
    small_amass(tmp_path / "bob" / "walk.npz", turns, trans, rate=60.0)
    (take,) = takes(tmp_path, frames_per_second=15)
    assert (len(take), take.performer) == (16, "bob")
    np.testing.assert_allclose(take.root_position[:, 0], np.arange(16) / 15, atol=1e-9)
    standing = skeleton.standing_height(skeleton.rotations_from_angles(take.angles))
    np.testing.assert_allclose(take.root_position[:, 1], standing, atol=1e-9)


class Bomb:
    """Leaves a mark where it is unpickled."""

    def __init__(self, mark):
        self.mark = mark

    def __reduce__(self):
        return (open, (str(self.mark), "w"))


BAD = {
    "no 'poses', only": {"poses": None},
    "no 'trans'": {"trans": None},
    "no 'mocap_framerate' or 'mocap_frame_rate'": {"mocap_framerate": None},
    "'poses' has shape (9, 10)": {"poses": np.zeros((9, 10))},
    "'poses' has shape (0, 156)": {"poses": np.zeros((0, 156))},
    "'poses' holds <U1": {"poses": np.full((9, 156), "a")},
    "'trans' has shape (3, 3), not (9, 3)": {"trans": np.zeros((3, 3))},
    "'poses' is not finite or huge in frame 4": {"poses": np.where(np.arange(9) == 4, np.nan, 0)
                                                 [:, None] * np.ones(156)},
    "'trans' is not finite or huge in frame 0": {"trans": np.full((9, 3), 1e30)},
    "'mocap_framerate' is -3.0": {"mocap_framerate": np.array(-3.0)},
    "'mocap_framerate' is nan": {"mocap_framerate": np.array(np.nan)},
}  # fmt: skip


@pytest.mark.parametrize("message", BAD)
def test_bad_files_are_named_with_their_key(tmp_path, small_amass, message):
    small_amass(tmp_path / "odd.npz", **BAD[message])
    with pytest.raises(InputError) as error:
        takes(tmp_path)
    assert "odd.npz" in str(error.value) and message in str(error.value)


@pytest.mark.parametrize("key", ["poses", "trans", "mocap_framerate"])
def test_pickled_objects_are_never_opened(tmp_path, small_amass, key):
    mark = tmp_path / "ran"
    small_amass(tmp_path / "bomb.npz", **{key: np.array([Bomb(mark)], dtype=object)})
    with pytest.raises(InputError, match=rf"bomb\.npz: '{key}' cannot be read: it is pickled"):
        takes(tmp_path)
    assert not mark.exists()


def test_a_pickle_that_nobody_needs_does_no_harm(tmp_path, small_amass):
    mark = tmp_path / "ran"
    small_amass(tmp_path / "a.npz", labels=np.array([Bomb(mark)], dtype=object))
    assert len(takes(tmp_path)) == 1
    assert not mark.exists()


@pytest.mark.parametrize("content", [b"", b"PK\x03\x04junk", b"\x93NUMPY\x01\x00", b"\x80\x04N."])
def test_no_archive(tmp_path, content):
    (tmp_path / "odd.npz").write_bytes(content)
    with pytest.raises(InputError, match=r"odd\.npz: is no \.npz archive"):
        takes(tmp_path)


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9])
def test_truncated(tmp_path, small_amass, share):
    file = small_amass(tmp_path / "cut.npz")
    content = file.read_bytes()
    file.write_bytes(content[: int(share * len(content))])
    with pytest.raises(InputError, match=r"cut\.npz"):
        takes(tmp_path)
