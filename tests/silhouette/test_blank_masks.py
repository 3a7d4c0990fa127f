import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette import is_blank, visible

PERSON, BLANK = np.eye(4), np.zeros((3, 5))


def test_blank_masks_are_left_out_if_they_may_be():
    found = visible([PERSON, BLANK, PERSON, BLANK], blank="nan")
    np.testing.assert_array_equal(found, [0, 2])
    np.testing.assert_array_equal(visible([PERSON, PERSON]), [0, 1])
    assert len(visible([])) == 0
    assert is_blank(BLANK) and not is_blank(PERSON)


@pytest.mark.parametrize(
    ("masks", "given", "message"),
    [
        ([PERSON, BLANK], {}, "mask 1 has no foreground: remove it, or .*blank='nan'"),
        ([PERSON, BLANK], {"names": ["a.png", "b.png"]}, "mask 'b.png' has no foreground"),
        ([BLANK, BLANK], {"blank": "nan"}, "none of the 2 masks has a foreground"),
        ([PERSON], {"blank": "zero"}, "blank must be 'error' or 'nan', not 'zero'"),
    ],
)
def test_what_is_refused_is_named(masks, given, message):
    with pytest.raises(InputError, match=message):
        visible(masks, **given)
