import pytest

from silpose.core.errors import InputError
from silpose.motion.capture.options import CaptureOptions


@pytest.mark.parametrize("rate", [0.0, -15.0, float("nan"), float("inf")])
def test_the_results_frame_rate_is_positive(rate):
    with pytest.raises(InputError, match=r"motion\.frames_per_second must be"):
        CaptureOptions(frames_per_second=rate)


@pytest.mark.parametrize("rate", [0.0, -30.0, float("nan"), 1e9])
def test_the_files_frame_rate_is_plausible(rate):
    with pytest.raises(InputError, match=r"motion\.frame_rate must be"):
        CaptureOptions(frame_rate=rate)


@pytest.mark.parametrize("axis", ["w", "Y", "+y", ""])
def test_an_unknown_axis(axis):
    with pytest.raises(InputError, match=r"motion\.up must be one of auto, x, y, z, -x"):
        CaptureOptions(up=axis)


def test_names_of_joints_are_checked():
    with pytest.raises(InputError, match="tentacle"):
        CaptureOptions(joints={"tentacle": ["Arm"]})
    assert dict(CaptureOptions(joints={"left_elbow": ["LFArm"]}).joints)
