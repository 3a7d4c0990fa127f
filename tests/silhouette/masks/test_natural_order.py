import pytest
from hypothesis import given
from hypothesis import strategies as st

from silpose.silhouette.masks.natural_order import (
    in_natural_order,
    kinds_of_names,
    takes_among,
    without_numbers,
)


@pytest.mark.parametrize(
    "ordered",
    [
        ["1", "2", "10"],
        ["0.8", "0.9", "1", "1.1", "1.25", "1.3"],  # seconds
        ["v1.8", "v1.9", "v1.10", "v1.11"],  # counted
        ["frame.0001", "frame.0002", "frame.0010"],
        ["001-nm-01-090-009", "001-nm-01-090-010", "001-nm-02-090-001"],
        ["a", "B", "c"],
        ["1690000000123456789", "1690000000123456790"],
        ["cam1-t-1", "cam1-t0"],
        ["t-10", "t-9", "t-1", "t0", "t5", "t10"],
        ["-1.5", "-1", "-0.5", "0", "0.5", "1"],  # seconds
        ["a_-2_mask", "a_-1_mask", "a_0_mask"],
        ["a0", "a1", "a-0", "a-1"],  # hyphens
        ["mask (1)", "mask (2)", "mask (10)"],
    ],
)
def test_names_are_in_the_order_of_their_numbers(ordered):
    assert [ordered[::-1][k] for k in in_natural_order(ordered[::-1])] == ordered


@given(st.lists(st.text(max_size=8), max_size=8))
def test_any_names_have_an_order_that_does_not_depend_on_theirs(names):
    order = [names[k] for k in in_natural_order(names)]
    again = [sorted(names)[k] for k in in_natural_order(sorted(names))]
    assert order == again


@given(st.lists(st.floats(0, 1000, allow_nan=False).map(lambda t: round(t, 3)), unique=True))
def test_times_as_python_writes_them_are_in_order(times):
    names = [str(time) for time in times if "e" not in str(time)]
    if not any(name.endswith("0") and not name.endswith(".0") for name in names):
        names = [name.removesuffix(".0") for name in names]
        ordered = [float(names[k]) for k in in_natural_order(names)]
        assert ordered == sorted(ordered)


def test_what_frames_have_in_common():
    assert without_numbers("001-nm-01_mask") == without_numbers("12-nm-7_mask") == "#-nm-#_mask"
    assert without_numbers("1.25") == without_numbers("3")
    assert kinds_of_names(["t-1", "t0"]) == ["t#", "t#"]
    assert kinds_of_names(["t-1", "t-0", "t0"]) == ["t-#", "t-#", "t#"]
    assert kinds_of_names(["t-1", "t1"]) == ["t-#", "t#"]


@pytest.mark.parametrize(
    ("names", "starts"),
    [
        (["cam1_0", "cam1_1", "cam1_2", "cam2_0", "cam2_1", "cam2_2", "cam2_3"], [0, 3]),
        ([f"00{s}-nm-01-{k:03d}" for s in (1, 2, 3) for k in range(4)], [0, 4, 8]),
        ([f"001-nm-01-090-{k:03d}" for k in range(12)], []),
        ([f"{k:04d}_mask" for k in range(12)], []),
        (["12-00-00.667", "12-00-01.334", "12-00-02.001", "12-00-02.668"], []),
        (["00-57", "00-58", "00-59", "01-00", "01-01", "01-02"], []),
        (["a", "b"], []),
        ([], []),
    ],
)
def test_names_that_count_anew_are_several_takes(names, starts):
    assert takes_among(names) == starts
