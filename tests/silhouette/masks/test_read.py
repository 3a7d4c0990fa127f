import warnings

import mask_encodings as ways
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

from silpose.core.errors import InputError
from silpose.silhouette.masks import MaskReader, MaskSequence, read_masks


@st.composite
def masks(draw):
    """A few masks of rectangles inside of a margin; not all are blank."""
    height, width = 2 * draw(st.integers(10, 20)), 2 * draw(st.integers(10, 20))
    drawn = []
    for _ in range(draw(st.integers(1, 4))):
        mask = np.zeros((height, width), np.uint8)
        for _ in range(draw(st.integers(0, 3))):
            top, left = draw(st.integers(5, height - 10)), draw(st.integers(5, width - 10))
            bottom = draw(st.integers(top + 3, height - 5))
            mask[top:bottom, left : draw(st.integers(left + 3, width - 5))] = 1
        drawn.append(mask)
    if not any(mask.any() for mask in drawn):
        drawn[0][8:14, 8:12] = 1
    return drawn


PAIRS = [
    *((encoding, way) for encoding in ways.ENCODINGS for way in ways.OF_ARRAYS),
    *((encoding, way) for encoding in ways.IN_BYTES for way in ways.OF_BYTES),
    *((encoding, way) for encoding in ("0 and 255", "inverted", "shadow") for way in ways.OF_FILMS),
]


def check(encoding, way, drawn, folder):
    source = way([ways.ENCODINGS[encoding](mask) for mask in drawn], folder)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        read = read_masks(source)
    assert len(read) == len(read.names) == len(drawn)
    for mask, expected in zip(read, drawn, strict=True):
        assert mask.dtype == np.uint8
        np.testing.assert_array_equal(mask, expected, err_msg=f"{encoding}, {way.__name__}, {read}")


@settings(max_examples=150, deadline=None)
@given(drawn=masks(), pair=st.sampled_from(PAIRS))
def test_any_encoding_handed_over_in_any_way_gives_the_same_masks(tmp_path_factory, drawn, pair):
    check(*pair, drawn, tmp_path_factory.mktemp("way"))


@pytest.mark.parametrize("encoding", ways.ENCODINGS)
def test_an_encoding_is_decided_for_all_pictures_together(tmp_path, encoding):
    """Two people's worth of area, a blank picture, and a small figure."""
    drawn = np.zeros((3, 64, 48), np.uint8)
    drawn[0, 8:60, 10:40] = drawn[2, 30:36, 20:24] = 1
    check(encoding, ways.array, drawn, tmp_path)


@settings(max_examples=40, deadline=None)
@given(drawn=masks(), encoding=st.sampled_from(sorted(ways.ENCODINGS)))
def test_a_stream_gives_the_masks_of_an_array(drawn, encoding):
    drawn = [mask for mask in drawn if mask.any()]  # what a first blank frame is, cannot be known
    pictures = [ways.ENCODINGS[encoding](mask) for mask in drawn]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        reader = MaskReader()
        for picture, mask in zip(pictures, drawn, strict=True):
            np.testing.assert_array_equal(reader.step(picture), mask)


HALF = np.repeat([0, 1], 32).reshape(8, 8).astype(np.uint8)
RUNS = {"size": [8, 8], "counts": ways.run_lengths_of(HALF)}


@pytest.mark.parametrize(
    "source",
    [HALF, [HALF], iter([HALF]), Image.fromarray(255 * HALF), RUNS, [RUNS], read_masks([HALF])],
    ids=["array", "list", "iterator", "image", "mapping", "records", "masks"],
)
def test_whatever_holds_a_mask_is_read(source):
    (mask,) = read_masks(source)
    np.testing.assert_array_equal(mask, HALF)
    if isinstance(source, MaskSequence):
        assert read_masks(source) is source


@pytest.mark.parametrize(
    ("source", "said"),
    [(None, "no masks, but None"), (3, "int 3 holds no masks"), ([], "the list holds no masks")],
)
def test_what_holds_none_is_refused(source, said):
    with pytest.raises(InputError, match=said):
        read_masks(source)
