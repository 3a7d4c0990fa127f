"""AMASS files are written here in its layout: there are none that may be shared."""

import sys

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from silpose.core import skeleton
from silpose.core.errors import InputError
from silpose.core.pose_space import wrap_degrees
from silpose.motion import MotionFolder
from silpose.motion.capture.formats.amass import holds_motion, read_amass

PARENTS = (-1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 12, 13, 14, 16, 17, 18, 19)


def some_turns(frames=5):
    return np.random.default_rng(0).normal(0, 0.4, (frames, 22, 3))


@pytest.mark.parametrize("columns", [156, 165, 66, 72])
def test_joints_turn_as_smpls_forward_kinematics_says(tmp_path, small_amass, columns):
    turns = some_turns()
    place = np.random.default_rng(1).normal(size=(5, 3))
    raw = read_amass(small_amass(tmp_path / "a.npz", turns, place, columns=columns))
    assert (raw.up, raw.unit, raw.format, len(raw), raw.notes) == ("z", 1.0, "AMASS", 5, ())
    world = [Rotation.from_rotvec(turns[:, 0])]
    for j in range(1, 22):
        world.append(world[PARENTS[j]] * Rotation.from_rotvec(turns[:, j]))
    for j, turned in enumerate(world):
        np.testing.assert_allclose(raw.rotations[:, j], turned.as_matrix(), atol=1e-9)
    np.testing.assert_allclose(raw.positions[:, 0], place)
    leg = raw.positions[:, raw.names.index("left_knee")] - raw.positions[:, 1]
    np.testing.assert_allclose(leg, world[1].apply(skeleton.OFFSETS["left_knee"]), atol=1e-9)
    assert raw.frames_per_second == 60.0


def test_at_zero_it_is_the_projects_zero_pose(tmp_path, small_amass):
    zero = read_amass(small_amass(tmp_path / "a.npz")).at_zero()
    points, _ = skeleton.forward_kinematics(np.tile(np.eye(3), (1, len(skeleton.JOINTS), 1, 1)))
    where = dict(zip(zero.names, zero.positions[0], strict=True))
    for ours, theirs in (("chest", "spine3"), ("neck", "neck"), ("left_wrist", "left_wrist"),
                         ("left_hand", "left_wrist/end"), ("right_toes", "right_foot"),
                         ("right_ankle", "right_ankle"), ("head_top", "head/end")):  # fmt: skip
        expected = points[0, skeleton.POINTS.index(ours)]
        np.testing.assert_allclose(where[theirs], expected, atol=1e-9)


def layouts(turns):
    """The same poses in the layouts of several generations and tools."""
    flat = np.zeros((len(turns), 156))
    flat[:, :66] = turns.reshape(len(turns), -1)
    none = {"poses": None}
    return [
        {"poses": flat.reshape(-1, 52, 3)},
        {"poses": flat.astype(np.float32)},
        none | {"root_orient": flat[:, :3], "pose_body": flat[:, 3:66], "pose_hand": flat[:, 66:]},
        none | {"global_orient": flat[:, None, :3], "body_pose": flat[:, 3:72].reshape(-1, 23, 3)},
        none | {"smpl_poses": flat[:, :72]},
        {"poses": flat, "trans": None, "transl": np.zeros((len(turns), 3))},
        {"poses": flat, "mocap_framerate": None, "fps": np.array([60])},
        {
            "poses": flat,
            "gender": np.array(None, dtype=object),
            "betas": np.array({}, dtype=object),
        },
        {"poses": flat, "mocap_framerate": np.array("60")},
        {"poses": flat, "gender": np.array(b"male"), "labels_obs": np.array([["a"], ["b"]])},
    ]


@pytest.mark.parametrize("layout", range(10))
def test_layouts(tmp_path, small_amass, layout):
    turns = some_turns()
    expected = read_amass(small_amass(tmp_path / "a.npz", turns))
    raw = read_amass(small_amass(tmp_path / "b.npz", turns, **layouts(turns)[layout]))
    np.testing.assert_allclose(raw.rotations, expected.rotations, atol=1e-6)
    np.testing.assert_allclose(raw.positions, expected.positions, atol=1e-6)
    assert raw.frames_per_second == 60.0 and raw.notes == ()


def test_degrees_are_read_as_such(tmp_path, small_amass):
    turns = some_turns()
    raw = read_amass(small_amass(tmp_path / "b.npz", np.rad2deg(turns)))
    expected = read_amass(small_amass(tmp_path / "a.npz", turns))
    np.testing.assert_allclose(raw.rotations, expected.rotations, atol=1e-9)
    assert "read as degrees" in raw.notes[0]


def test_the_rate_may_be_given(tmp_path, small_amass):
    for rate in (None, np.array(-3.0)):
        file = small_amass(tmp_path / "a.npz", mocap_framerate=rate)
        assert read_amass(file, frame_rate=90).frames_per_second == 90


class Bomb:
    """Leaves a mark where it is unpickled."""

    def __init__(self, mark):
        self.mark = mark

    def __reduce__(self):
        return (open, (str(self.mark), "w"))


BAD = {
    "has no 'poses', only": {"poses": None},
    "has no 'trans', only": {"trans": None},
    "has no 'mocap_framerate' or 'mocap_frame_rate', only": {"mocap_framerate": None},
    "'poses' has shape (9, 10)": {"poses": np.zeros((9, 10))},
    "'poses' has shape (0, 156)": {"poses": np.zeros((0, 156))},
    "'poses' has shape (0, 0, 3)": {"poses": np.zeros((0, 0, 3))},
    "'poses' has shape (9, 24, 3, 3)": {"poses": np.zeros((9, 24, 3, 3))},
    "'poses' has shape ()": {"poses": np.array(3.0)},
    "'poses' holds <U1": {"poses": np.full((9, 156), "a")},
    "'trans' has shape (3, 3), not (9, 3)": {"trans": np.zeros((3, 3))},
    "'poses' is not finite or huge in frame 4": {"poses": np.where(np.arange(9) == 4, np.nan, 0)
                                                 [:, None] * np.ones(156)},
    "'poses' holds turns up to": {"poses": np.full((9, 156), 1000.0)},
    "'trans' is not finite or huge in frame 0": {"trans": np.full((9, 3), 1e30)},
    "'mocap_framerate' is -3.0": {"mocap_framerate": np.array(-3.0)},
    "'mocap_framerate' is of shape": {"mocap_framerate": np.full(99, 60.0)},
    "'mocap_framerate' is nan": {"mocap_framerate": np.array(np.nan)},
}  # fmt: skip


@pytest.mark.parametrize("message", BAD)
def test_bad_files_are_named_with_their_key(tmp_path, small_amass, message):
    small_amass(tmp_path / "odd.npz", **BAD[message])
    with pytest.raises(InputError) as error:
        read_amass(tmp_path / "odd.npz")
    assert f"odd.npz: {message}" in str(error.value) and "archive" not in str(error.value)


@pytest.mark.parametrize("joints", [22, 24, 52])
@pytest.mark.parametrize("kind", ["quaternions", "two columns", "two columns, by rows", "matrices"])
def test_other_rotations_are_refused_with_how_to_convert_them(tmp_path, small_amass, joints, kind):
    turns = Rotation.random(8 * joints, random_state=np.random.default_rng(0))
    matrices = turns.as_matrix()
    values = {
        "quaternions": turns.as_quat(),
        "two columns": np.swapaxes(matrices[:, :, :2], 1, 2),
        "two columns, by rows": matrices[:, :, :2],
        "matrices": matrices,
    }[kind]
    for shape in ((8, -1), (8, joints, *values.shape[1:])):
        small_amass(tmp_path / "a.npz", poses=values.reshape(shape))
        with pytest.raises(
            InputError, match=rf"no axis-angles.* {kind.split(',')[0]}.*{joints}, 3"
        ):
            read_amass(tmp_path / "a.npz")


@pytest.mark.parametrize("key", ["poses", "trans", "mocap_framerate"])
def test_pickled_objects_are_never_opened(tmp_path, small_amass, key):
    mark = tmp_path / "ran"
    small_amass(tmp_path / "bomb.npz", **{key: np.array([Bomb(mark)], dtype=object)})
    with pytest.raises(InputError, match=rf"bomb\.npz: '{key}' cannot be read: it is pickled"):
        read_amass(tmp_path / "bomb.npz")
    assert not mark.exists()


def test_a_pickle_that_nobody_needs_does_no_harm(tmp_path, small_amass):
    mark = tmp_path / "ran"
    small_amass(tmp_path / "a.npz", labels=np.array([Bomb(mark)], dtype=object))
    assert len(read_amass(tmp_path / "a.npz")) == 9
    assert not mark.exists()


def test_what_holds_motion(tmp_path, small_amass):
    (tmp_path / "cut.npz").write_bytes(b"PK\x03\x04junk")
    np.savez(tmp_path / "shape.npz", gender=np.array("female"), betas=np.zeros(16))
    np.savez(tmp_path / "neutral_stagei.npz", betas=np.zeros(16), markers_latent=np.zeros((4, 3)))
    small_amass(tmp_path / "no_trans.npz", trans=None)
    small_amass(tmp_path / "no_poses.npz", poses=None)
    held = {file.name for file in tmp_path.iterdir() if holds_motion(file)}
    assert held == {"cut.npz", "no_trans.npz", "no_poses.npz"}


@pytest.mark.filterwarnings("ignore::UserWarning")  # nobody moves so
def test_takes_have_the_limbs_and_the_heading_of_the_file(tmp_path, small_amass):
    turns = 0.6 * some_turns(31)
    heading = Rotation.from_euler("Z", np.linspace(0, 3, 31)[:, None])
    lean = Rotation.from_rotvec(0.2 * turns[:, 0])
    turns[:, 0] = (heading * Rotation.from_euler("X", 90, degrees=True) * lean).as_rotvec()
    file = small_amass(tmp_path / "a" / "walk_poses.npz", turns, rate=30.0)
    (take,) = MotionFolder(tmp_path, formats=["npz"], frames_per_second=30).takes()
    raw = read_amass(file)
    points, _ = skeleton.forward_kinematics(skeleton.rotations_from_angles(take.angles))
    ours = {name: points[:, p] for p, name in enumerate(skeleton.POINTS)}
    for start, end in skeleton.LIMBS.items():
        theirs = f"{start}/end" if end.endswith("hand") else end
        bone = raw.positions[:, raw.names.index(theirs)] - raw.positions[:, raw.names.index(start)]
        expected, found = bone[:, [0, 2, 1]] * [1, 1, -1], ours[end] - ours[start]
        np.testing.assert_allclose(found, expected, atol=1e-6)
    x = raw.rotations[:, 0, :, 0]  # the pelvis's, whose heading counts
    heading = np.rad2deg(np.arctan2(x[:, 1], x[:, 0]))
    assert np.abs(wrap_degrees(heading - take.angles[:, 0])).max() < 0.01


@pytest.mark.parametrize("shape", [(0, 3), ()])
def test_no_frames_in_two_arrays_are_refused(tmp_path, shape):
    file = tmp_path / "empty.npz"
    arrays = {"root_orient": np.zeros(shape), "pose_body": np.zeros(shape)}
    np.savez(file, trans=np.zeros((0, 3)), mocap_framerate=30, **arrays)
    with pytest.raises(InputError, match=r"'root_orient' has shape"):
        read_amass(file)


def test_more_frames_than_fit_into_memory_are_refused(tmp_path, small_amass, monkeypatch):
    file = small_amass(tmp_path / "a.npz", some_turns())
    monkeypatch.setattr(sys.modules[read_amass.__module__], "LARGEST_SIZE", 100)
    with pytest.raises(InputError, match="5 frames, more than fit into memory"):
        read_amass(file)
