"""BVH files as people have them: read rightly, or refused with the line that is wrong."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from silpose.core.errors import InputError
from silpose.motion.capture.formats.bvh import read_bvh

FRAMES = [
    {"root": (0, 20 * f, 0), "left_hip": (5, 0, -20), "position": (f, 45, 0)} for f in range(9)
]
ANY_FOLDER = settings(deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])


@pytest.fixture
def read(tmp_path):
    """Write text, or bytes, to a file and read it."""

    def call(content, **more):
        file = tmp_path / "odd.bvh"
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        return read_bvh(file, **more)

    return call


@pytest.fixture
def refusal(read):
    """The message with which a text is refused."""

    def call(content, **more):
        with pytest.raises(InputError) as error:
            read(content, **more)
        message = str(error.value)
        assert "odd.bvh: " in message and "\n" not in message
        return message

    return call


def same(one, other):
    assert one.names == other.names and one.parents == other.parents
    np.testing.assert_allclose(one.positions, other.positions, atol=1e-9)
    np.testing.assert_allclose(one.rotations, other.rotations, atol=1e-9)
    assert one.frames_per_second == other.frames_per_second


def test_tree_and_kinematics(read, small_bvh):
    raw = read(small_bvh(FRAMES).text())
    assert (len(raw), raw.frames_per_second, raw.format) == (9, 30, "BVH")
    assert raw.up is None and raw.unit is None
    hips, hip, knee = (raw.names.index(name) for name in ("Hips", "LeftUpLeg", "LeftLeg"))
    assert raw.parents[hips] == -1 and raw.parents[knee] == hip and raw.parents[hip] == hips
    assert raw.names.count("LeftHand/end") == 1
    turned = Rotation.from_euler("y", 20 * np.arange(9)[:, None], degrees=True)
    place = np.stack([np.arange(9), np.full(9, 45), np.zeros(9)], axis=1)
    np.testing.assert_allclose(raw.positions[:, hips], place, atol=1e-9)
    expected = place + turned.apply(raw.offsets[hip])
    np.testing.assert_allclose(raw.positions[:, hip], expected, atol=1e-9)
    leg = (turned * Rotation.from_euler("ZX", (5, -20), degrees=True)).apply(raw.offsets[knee])
    np.testing.assert_allclose(raw.positions[:, knee], expected + leg, atol=1e-9)
    assert raw.notes == ()


@pytest.mark.parametrize(
    "change",
    [
        lambda t: t.replace("\n", "\r\n").encode(),
        lambda t: t.replace("\n", "\r").encode(),
        lambda t: t.encode("utf-8-sig"),
        lambda t: t.encode("utf-16"),
        lambda t: t.encode("utf-16-le"),
        lambda t: t.encode("utf-16-be"),
        lambda t: t.encode() + b"\x1a",
        lambda t: t.encode().rstrip() + b"\x00\x00",
        lambda t: ("\n\nmade by hand\n" + t).encode(),
        lambda t: t.replace("HIERARCHY\nROOT", "HIERARCHY ROOT").encode(),
        lambda t: t.replace("MOTION\nFrames", "MOTION Frames").encode(),
        lambda t: t.replace("MOTION", "Motion").replace("HIERARCHY", "hierarchy").encode(),
        lambda t: t.replace(" 45 ", ", 45, ").encode(),
        lambda t: t.replace("0.0 0.0 0.0", "0.0,0.0,0.0").encode(),
        lambda t: t.replace("0.0 ", "0.0\t").encode(),
    ],
)
def test_texts_of_many_machines(read, small_bvh, change):
    text = small_bvh(FRAMES).text()
    same(read(change(text)), read(text))


def test_values_may_follow_the_frame_time_on_its_line(read, small_bvh):
    text = small_bvh(FRAMES).text()
    same(read(text.replace("0333333\n", "0333333 ")), read(text))


def test_decimal_commas(read, small_bvh):
    text = small_bvh(FRAMES).text()
    commas = read(text.replace(".", ","))
    same(commas, read(text))
    assert "decimal commas" in commas.notes[0]


def test_latin_1_names(read, small_bvh):
    text = small_bvh(FRAMES, names={"head": "tête"}).text()
    assert "tête" in read(text.encode("latin-1")).names
    assert "tête" in read(text.encode()).names


@pytest.mark.parametrize(
    "content", ["", "hello\n", "PK\x03\x04\x00\xff", "HIERARCHY\n", "\x00" * 50]
)
def test_no_bvh(refusal, content):
    assert "no BVH file" in refusal(content)


@pytest.mark.parametrize(
    ("content", "what"),
    [
        ("version https://git-lfs.github.com/spec/v1\noid sha256:0", "git lfs pull"),
        ("<!DOCTYPE html><html>", "web page"),
        ("PK\x03\x04", "zip"),
        ("Kaydara FBX Binary", "FBX"),
    ],
)
def test_what_it_is_instead(refusal, content, what):
    assert what in refusal(content)


@pytest.mark.parametrize("share", [0.1, 0.3, 0.5, 0.7, 0.9, 0.97])
def test_truncated(refusal, small_bvh, share):
    text = small_bvh([{}] * 20).text()
    assert "truncated" in refusal(text[: int(share * len(text))])


def test_a_missing_folder(tmp_path):
    with pytest.raises(InputError, match="cannot be read"):
        read_bvh(tmp_path / "nowhere.bvh")


def test_two_joints_of_one_name(refusal, small_bvh):
    twins = small_bvh(names={"left_knee": "Knee", "right_knee": "Knee"})
    assert "has two joints 'Knee'" in refusal(twins.text())


def test_ends_of_one_name(read, small_bvh):
    text = small_bvh().text()
    tips = text.replace("End Site", "JOINT Nub")
    assert {"Nub", "Nub2", "Nub3"} < set(read(tips).names)


@pytest.mark.parametrize("bad", ["nan", "inf", "1e30", "-1e7"])
@pytest.mark.parametrize(("what", "kind"), [("head", "rotation"), ("position", "position")])
def test_numbers_not_plausible(refusal, small_bvh, bad, what, kind):
    text = small_bvh([{}, {}, {what: (0, bad, 0)}]).text()
    line = next(n for n, row in enumerate(text.split("\n"), start=1) if bad in row)
    assert f"frame 2, line {line}, holds a {kind}" in refusal(text)


def test_the_rate_may_be_given(read, refusal, small_bvh):
    assert "frame time" in refusal(small_bvh(frame_time="-1").text())
    assert read(small_bvh(frame_time="-1").text(), frame_rate=60).frames_per_second == 60
    text = small_bvh().text().replace("Frame Time: 0.0333333\n", "")
    assert "motion.frame_rate=30" in refusal(text)
    assert read(text, frame_rate=30).frames_per_second == 30


def test_no_channels_at_all(refusal, small_bvh):
    lines = [line for line in small_bvh().text().split("\n") if "CHANNELS" not in line]
    assert "none of its joints has CHANNELS" in refusal("\n".join(lines))


PROP = "ROOT Prop\n{\nOFFSET 0 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n}\n"


@pytest.mark.parametrize("before", [True, False])
@pytest.mark.parametrize("value", ["7", "nan"])
def test_an_extra_root_is_left_out(read, small_bvh, before, value):
    hierarchy, motion = small_bvh(FRAMES).text().split("MOTION")
    head, *rows = motion.rstrip().rpartition("0333333\n")[0::2]
    more = f"{value} 1 2"
    rows = [f"{more} {row}" if before else f"{row} {more}" for row in rows[0].split("\n")]
    tree = hierarchy.replace("ROOT", PROP + "ROOT") if before else hierarchy + PROP
    found = read(f"{tree}MOTION{head}0333333\n" + "\n".join(rows) + "\n")
    same(found, read(small_bvh(FRAMES).text()))
    assert "the ROOT 'Prop' in line" in found.notes[0]


def test_two_figures(refusal, small_bvh):
    hierarchy, motion = small_bvh([{}]).text().split("MOTION")
    head, row = motion.rstrip().rpartition("0333333\n")[0::2]
    both = hierarchy + hierarchy.replace("HIERARCHY\n", "")
    message = refusal(f"{both}MOTION{head}0333333\n{row} {row}\n")
    assert "two figures, ROOT 'Hips' in line 2 and ROOT 'Hips'" in message


def test_too_much_for_the_memory(refusal, small_bvh, monkeypatch):
    monkeypatch.setattr("silpose.motion.capture.formats.bvh.reader.LARGEST_SIZE", 100)
    assert "shorter takes" in refusal(small_bvh([{}] * 20).text())


def test_too_large_a_file(refusal, small_bvh, monkeypatch):
    monkeypatch.setattr("silpose.motion.capture.formats.text_file.LARGEST", 1000)
    assert "shorter takes" in refusal(small_bvh([{}] * 20).text())


_AXES = ("x", "y", "z")


@st.composite
def trees(draw):
    """A random tree: parent, channels and offset of each node."""
    count = draw(st.integers(1, 8))
    nodes = []
    for j in range(count):
        turns = draw(st.lists(st.sampled_from(_AXES), max_size=4))
        moves = draw(st.lists(st.sampled_from(_AXES), max_size=3, unique=True))
        channels = draw(st.permutations([*(f"{a}r" for a in turns), *(f"{a}p" for a in moves)]))
        offset = draw(st.tuples(*[st.integers(-9, 9)] * 3))
        nodes.append((draw(st.integers(0, j - 1)) if j else -1, channels, offset))
    nodes[0][1].append("yr")
    return nodes


def _text(nodes, values):
    def joint(j):
        _, channels, offset = nodes[j]
        names = [c[0].upper() + {"r": "rotation", "p": "position"}[c[1]] for c in channels]
        order.append(j)
        yield f"{'JOINT' if j else 'ROOT'} node {j}\n{{\nOFFSET {' '.join(map(str, offset))}"
        if names:
            yield f"CHANNELS {len(names)} {' '.join(names)}"
        for child in range(len(nodes)):
            if nodes[child][0] == j:
                yield from joint(child)
        yield "}"

    order = []
    hierarchy = "\n".join(joint(0))
    rows = [" ".join(repr(v) for j in order for v in frame[j]) for frame in values]
    head = f"MOTION\nFrames: {len(rows)}\nFrame Time: 0.04"
    return "\n".join(["HIERARCHY", hierarchy, head, *rows])


@settings(ANY_FOLDER, max_examples=30)
@given(nodes=trees(), seed=st.integers(0, 99))
def test_any_layout_of_channels(read, nodes, seed):
    rng = np.random.default_rng(seed)
    # at least 10: all zero positions would be movements
    values = [[10 + 90 * rng.random(len(channels)) for _, channels, _ in nodes] for _ in range(3)]
    values = [[[float(v) for v in node] for node in frame] for frame in values]
    raw = read(_text(nodes, values))
    for f, frame in enumerate(values):
        world = []
        for j, (parent, channels, offset) in enumerate(nodes):
            step, turned = np.array(offset, float), Rotation.identity()
            for channel, value in zip(channels, frame[j], strict=True):
                if channel[1] == "p":
                    step[_AXES.index(channel[0])] = value
                else:
                    turned = turned * Rotation.from_euler(channel[0], value, degrees=True)
            if parent >= 0:
                above, place = world[parent]
                step, turned = place + above.apply(step), above * turned
            world.append((turned, step))
        for j, (turned, place) in enumerate(world):
            k = raw.names.index(f"node {j}")
            np.testing.assert_allclose(raw.positions[f, k], place, atol=1e-6)
            np.testing.assert_allclose(raw.rotations[f, k], turned.as_matrix(), atol=1e-9)


JUNK = st.one_of(
    st.sampled_from(["", "nan", "1e400", "{", "}", "End Site\n", "\x00\xff", "JOINT x\n{\n", ",",
                     "MOTION\n", "ROOT y\n{\n", "Frames: 1e30\n", "CHANNELS 9\n", "/end",
                     "\u2028"]),
    st.text(max_size=8),
    st.binary(max_size=8),
)  # fmt: skip
DAMAGES = st.lists(st.tuples(st.floats(0, 1), JUNK, st.integers(0, 40)), min_size=1, max_size=3)


@settings(ANY_FOLDER, max_examples=60)
@given(places=DAMAGES)
def test_no_damage_crashes(read, small_bvh, places):
    content = small_bvh([{"left_hip": (1, 2, 33.25)}] * 3).text().encode()
    for share, junk, cut in places:
        at = int(share * len(content))
        junk = junk if isinstance(junk, bytes) else junk.encode(errors="replace")
        content = content[:at] + junk + content[at + cut :]
    try:
        raw = read(content)
    except InputError as error:
        assert "odd.bvh" in str(error) and "\n" not in str(error)
    else:
        assert np.isfinite(raw.positions).all() and np.isfinite(raw.rotations).all()
        assert len(set(raw.names)) == len(raw.names) == raw.positions.shape[1] == len(raw.parents)


@settings(ANY_FOLDER, max_examples=40)
@given(st.one_of(st.text(), st.binary()))
def test_anything_at_all_is_no_bvh(refusal, content):
    refusal(content if isinstance(content, bytes) else content.encode(errors="replace"))


@pytest.mark.shared
@pytest.mark.parametrize(
    ("file", "joints", "rate"),
    [("snu/wd2_cross_walk_90d_07", 31, 30), ("cmu/08_01", 38, 120), ("cmu69/69_03_1", 27, 30)],
)
def test_real_files_are_read_without_any_assumption(shared_mocap, file, joints, rate):
    raw = read_bvh(shared_mocap / f"{file}.bvh")
    assert (len(raw.names), raw.frames_per_second, raw.notes) == (joints, rate, ())
