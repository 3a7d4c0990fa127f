from pathlib import Path

import pytest

from silpose.core.errors import InputError
from silpose.motion.capture.formats.bvh.hierarchy import parse_hierarchy

TEXT = """\
HIERARCHY
ROOT Bip01 Pelvis
{
  OFFSET 0 1.5 -2e-1
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Bip01 L Thigh
  {
    OFFSET 1 0 0
    CHANNELS 1 Xrotation
    End Site
    {
      OFFSET 0 0 1
    }
  }
  JOINT toe
  {
    OFFSET 0 0 1
  }
}
"""


def parse(text):
    return parse_hierarchy(text.split("\n"), Path("a.bvh"))


def table(nodes):
    return [(n.name, n.parent, n.is_end, "".join(n.channels), n.offset) for n in nodes]


WHOLE = [
    ("Bip01 Pelvis", -1, False, "xpypzpzrxryr", (0, 1.5, -0.2)),
    ("Bip01 L Thigh", 0, False, "xr", (1, 0, 0)),
    ("Bip01 L Thigh/end", 1, True, "", (0, 0, 1)),
    ("toe", 0, False, "", (0, 0, 1)),
]


def test_names_tree_channels_and_offsets():
    nodes = parse(TEXT)
    assert table(nodes) == WHOLE
    assert [node.line for node in nodes] == [2, 6, 10, 15]


@pytest.mark.parametrize(
    "change",
    [
        lambda t: t.replace("\n{", " {").replace("  {", " {"),
        lambda t: t.replace("ROOT", "root").replace("JOINT", "Joint").replace("OFFSET", "Offset"),
        lambda t: t.replace("CHANNELS", "channels").replace("rotation", "ROTATION"),
        lambda t: t.replace("End Site", "End site").replace("HIERARCHY", "Hierarchy"),
        lambda t: t.replace("End Site", "EndSite"),
        lambda t: t.replace("End Site", "End Site ball of the toe"),
        lambda t: t.replace("  ", "\t"),
        lambda t: t.replace("Yposition Z", "Yposition\n    Z"),
        lambda t: t.replace("OFFSET 0 0 1\n", "OFFSET 0\n 0 1\n"),
        lambda t: t.replace("OFFSET 0 0 1\n  }", "OFFSET 0 0 1\n CHANNELS 0\n }"),
        lambda t: t.replace("Xrotation\n", "Xrot\n"),
        lambda t: t.replace("HIERARCHY\n", "HIERARCHY\n# made by hand\n// or not\n\n"),
    ],
)
def test_spellings(change):
    text = change(TEXT)
    assert text != TEXT and table(parse(text)) == WHOLE


@pytest.mark.parametrize(
    ("right", "wrong", "line", "reason"),
    [
        ("ROOT", "JOINT", 2, "outside of any ROOT"),
        ("JOINT toe", "ROOT toe", 15, "inside another joint"),
        ("JOINT toe", "JOINT", 15, "has no name"),
        ("JOINT toe", "JIONT toe", 15, "'JIONT'"),
        ("6 Xposition", "5 Xposition", 5, "'Yrotation'"),
        ("1 Xrotation", "2 Xrotation", 10, "'End'"),
        ("1 Xrotation", "1 Wrotation", 9, "'Wrotation'"),
        ("1 Xrotation", "one Xrotation", 9, "'one'"),
        ("1 Xrotation", "1e9 Xrotation", 9, "'1e9'"),
        ("Yposition", "Xposition", 5, "stands twice"),
        ("OFFSET 1 0 0", "OFFSET 1 0", 9, "'CHANNELS'"),
        ("OFFSET 1 0 0", "OFFSET 1 0 0 0", 8, "'0'"),
        ("OFFSET 1 0 0", "OFFSET 1 0 nan", 8, "'Bip01 L Thigh'"),
        ("OFFSET 1 0 0", "OFFSET 1 0 1e9", 8, "'1e9'"),
        ("OFFSET 1 0 0", "", 6, "no OFFSET"),
        ("OFFSET 1 0 0", "OFFSET 1 0 0\n OFFSET 1 0 0", 9, "second OFFSET"),
        ("ROOT Bip01 Pelvis\n{", "ROOT Bip01 Pelvis\n", 4, "'{' is missing"),
        ("    }\n  }\n", "    }\n  }\n  }\n}\n", 16, "too many"),
    ],
)
def test_damage_is_named_with_its_line(right, wrong, line, reason):
    with pytest.raises(InputError) as error:
        parse(TEXT.replace(right, wrong, 1))
    assert f"a.bvh: line {line}: " in str(error.value) and reason in str(error.value)


def test_a_lost_brace():
    with pytest.raises(InputError, match="truncated"):
        parse(TEXT.rstrip()[:-1])


def test_millions_of_joints_are_refused():
    joint = "JOINT a\n{\nOFFSET 0 0 0\n"
    with pytest.raises(InputError, match="more than 2000 joints"):
        parse("HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\n" + 5000 * joint + 5001 * "}\n")


def test_deep_trees():
    joint = "JOINT a\n{\nOFFSET 0 0 0\n"
    nodes = parse("HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\n" + 1500 * joint + 1501 * "}\n")
    assert [node.parent for node in nodes] == list(range(-1, 1500))
