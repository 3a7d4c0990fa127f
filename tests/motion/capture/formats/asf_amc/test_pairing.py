import pytest

from silpose.core.errors import InputError
from silpose.motion.capture.formats.asf_amc.pairing import find_skeleton


def tree(root, *names):
    for name in names:
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).touch()


@pytest.mark.parametrize(
    ("amc", "others", "expected"),
    [
        ("02_01.amc", ["02.asf", "20.asf", "0.asf"], "02.asf"),
        ("02_01.AMC", ["02.ASF", "2.asf"], "02.ASF"),
        ("HDM_bd_01-01_01_120.amc", ["HDM_bd.asf", "HDM.asf", "HDM_bk.asf"], "HDM_bd.asf"),
        ("walk.amc", ["walk.asf", "run.asf"], "walk.asf"),
        (
            "subjects/02/02_01.amc",
            ["subjects/02/02.asf", "subjects/03/03.asf"],
            "subjects/02/02.asf",
        ),
        ("amc/02_01.amc", ["02.asf", "03.asf"], "02.asf"),
        ("amc/02_01.amc", ["asf/02.asf", "asf/03.asf"], "asf/02.asf"),
        ("02_01.amc", ["02.asf", "._02.asf"], "02.asf"),
    ],
)
def test_by_name(tmp_path, amc, others, expected):
    tree(tmp_path, amc, *others)
    assert find_skeleton(tmp_path / amc) == (tmp_path / expected, ())


@pytest.mark.parametrize("where", ["b", "."])
def test_the_only_one_may_have_any_name(tmp_path, where):
    tree(tmp_path, "b/walk.amc", f"{where}/person.asf")
    asf, (note,) = find_skeleton(tmp_path / "b" / "walk.amc")
    assert asf == tmp_path / where / "person.asf" and "person.asf" in note


@pytest.mark.parametrize("others", [[], ["a.asf", "b.asf"], ["022.asf", "0.asf"]])
def test_not_sure(tmp_path, others):
    tree(tmp_path, "b/02_01.amc", *(f"b/{name}" for name in others))
    with pytest.raises(InputError, match=r"02_01\.amc: its skeleton is not sure.*02\.asf for"):
        find_skeleton(tmp_path / "b" / "02_01.amc")
