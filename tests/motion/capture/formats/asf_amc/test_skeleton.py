import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.motion.capture.formats.asf_amc.skeleton import read_skeleton


def read(folder, text):
    (folder / "02.asf").write_text(text)
    return read_skeleton(folder / "02.asf")


def test_bones(tmp_path, small_asf):
    skeleton = read(tmp_path, small_asf().asf())
    assert list(skeleton.bones) == ["root", "lowerback", "thorax", "lhumerus", "lradius", "skull",
                                    "lfemur"]  # fmt: skip
    assert (skeleton.length, skeleton.degrees) == (0.45, True)
    thorax = skeleton.bones["thorax"]
    np.testing.assert_allclose(thorax.vector, (0, 1.5, 0))
    assert thorax.moves == ("rz", "rx", "ry") and thorax.parent == "lowerback"
    assert skeleton.bones["skull"].moves == ()


@pytest.mark.parametrize(
    "change",
    [
        lambda t: t.replace("\n", "\r\n"),
        lambda t: t.replace("  ", "\t"),
        lambda t: t.replace("XYZ", "xyz").replace(" TX", " tx"),
        lambda t: t.replace(":bonedata", ":BONEDATA").replace("begin", "BEGIN"),
        lambda t: t.replace("    lowerback thorax\n", "\n    lowerback thorax # the back\n"),
    ],
)
def test_spellings(tmp_path, small_asf, change):
    bones = read(tmp_path, change(small_asf().asf())).bones
    assert list(bones) == list(read(tmp_path, small_asf().asf()).bones)


def test_radians(tmp_path, small_asf):
    degrees = read(tmp_path, small_asf().asf()).bones["lfemur"].axes
    text = small_asf().asf().replace("0 0 20 XYZ", f"0 0 {np.deg2rad(20)} XYZ")
    skeleton = read(tmp_path, text.replace("angle deg", "angle rad"))
    np.testing.assert_allclose(skeleton.bones["lfemur"].axes, degrees)
    assert not skeleton.degrees


@pytest.mark.parametrize(
    ("right", "wrong", "reason"),
    [
        (":hierarchy", ":tree", "no ':hierarchy'"),
        (":bonedata", ":bones", "no ':bonedata'"),
        ("name thorax", "name", "has no name"),
        ("name thorax", "name lowerback", "two bones 'lowerback'"),
        ("length 1.5", "length", "1 numbers should be here"),
        ("length 1.5", "length nan", "'nan'"),
        ("direction 0 2 0", "direction 0 2", "3 numbers should be here, not '0 2'"),
        ("direction 0 2 0", "direction 0 0 0", "'thorax' has no direction"),
        ("dof rz rx ry", "dof rz rx rw", "'rw' is no degree of freedom"),
        ("dof rz rx ry", "dof rz rx rx", "'rx' is no degree of freedom"),
        ("10 20 30 XYZ", "10 20 30 XYY", "'XYY'"),
        ("    lowerback thorax\n", "", "'thorax' has no parent"),
        ("lowerback thorax", "lowerback chest", "no bone 'chest'"),
        ("root lowerback lfemur", "root lowerback lfemur thorax", "'thorax' has two parents"),
        ("thorax lhumerus skull", "thorax lhumerus root", "'root' has two parents"),
        (":hierarchy\n  begin", ":hierarchy\n", None),
    ],
)
def test_damage_is_named(tmp_path, small_asf, right, wrong, reason):
    text = small_asf().asf()
    assert right in text
    if reason is None:
        read(tmp_path, text.replace(right, wrong, 1))
        return
    with pytest.raises(InputError) as error:
        read(tmp_path, text.replace(right, wrong, 1))
    assert "02.asf: " in str(error.value) and reason in str(error.value)
