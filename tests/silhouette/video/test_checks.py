import pytest

from silpose.core.errors import InputError
from silpose.silhouette.video import VideoMasks


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("samples", 0), ("threshold", 0), ("threshold", float("nan")), ("shadow_darkest", 2),
        ("opening", -1), ("longest_side", 0), ("first", -1), ("last", -2), ("history", 0),
        ("frames_per_second", 0), ("background", "mean"), ("person", "middle"),
    ],
)  # fmt: skip
def test_what_has_no_meaning_is_refused_by_name(film, name, value):
    with pytest.raises(InputError, match=name):
        VideoMasks(film, **{name: value})
