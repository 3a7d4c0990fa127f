import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from mask_encodings import run_lengths_of

from silpose.core.errors import InputError
from silpose.silhouette.masks.run_lengths import mask_of_run_lengths

masks = arrays.arrays(
    np.uint8, st.tuples(st.integers(1, 9), st.integers(1, 300)), elements=st.integers(0, 1)
)


@given(masks)
def test_numbers_are_read(mask):
    item = {"size": list(mask.shape), "counts": run_lengths_of(mask)}
    np.testing.assert_array_equal(mask_of_run_lengths(item, "mask"), mask)


@given(masks)
def test_text_is_read_as_pycocotools_writes_it(mask):
    coco = pytest.importorskip("pycocotools.mask")
    item = coco.encode(np.asfortranarray(mask))
    for counts in (item["counts"], item["counts"].decode()):
        read = mask_of_run_lengths({"size": item["size"], "counts": counts}, "mask")
        np.testing.assert_array_equal(read, mask)


def test_text_is_read():
    item = {"size": [20, 30], "counts": "c26>00000000000i;"}
    expected = np.zeros((20, 30), np.uint8)
    expected[3:9, 4:11] = 1
    np.testing.assert_array_equal(mask_of_run_lengths(item, "mask"), expected)


@given(st.text(max_size=20), st.integers(1, 50), st.integers(1, 50))
def test_any_other_text_is_refused_or_fills_the_mask(text, height, width):
    try:
        mask = mask_of_run_lengths({"size": [height, width], "counts": text}, "mask")
    except InputError as error:
        assert str(error).startswith("mask has run")
    else:
        assert mask.shape == (height, width) and mask.max() <= 1


@pytest.mark.parametrize(
    "item",
    [
        {"size": [4, 5], "counts": [3, 4]},
        {"size": [4, 5], "counts": [30, -10]},
        {"size": [4], "counts": [4]},
        {"size": None, "counts": [4]},
        {"size": [4, 5], "counts": None},
        {"size": [4, 5], "counts": [[1, 2], [3]]},
        {"size": [256, 256], "counts": "abc"},
        {"size": [1, 1], "counts": "1P"},  # ends within a number
        {"size": [1, 1], "counts": "Q" + 11 * "P" + "0"},  # 1, at length
    ],
)
def test_runs_that_do_not_fit_are_refused(item):
    with pytest.raises(InputError, match="mask has run"):
        mask_of_run_lengths(item, "mask")


@pytest.mark.parametrize("size", [[0, 5], [10**6, 10**6]])
def test_sizes_that_cannot_be_are_refused(size):
    with pytest.raises(InputError, match="mask has a size of"):
        mask_of_run_lengths({"size": size, "counts": [size[0] * size[1]]}, "mask")
