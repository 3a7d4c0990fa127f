import pytest

from silpose.core.errors import InputError
from silpose.silhouette import MaskSource


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"blank": "skip"}, "blank must be 'error' or 'nan', not 'skip'"),
        ({"frames_per_second": 0}, "frames_per_second must be a positive number"),
        ({"frames_per_second": float("nan")}, "frames_per_second must be a positive number"),
        ({"threshold": float("inf")}, "threshold must be a number"),
    ],
)
def test_wrong_settings_are_named(settings, message):
    with pytest.raises(InputError, match=message):
        MaskSource(**settings)
