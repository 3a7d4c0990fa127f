import pytest

from silpose.motion.capture.places import Pace, moved, pace_of_hips, same_unit


def test_hips_move_as_fast_as_standing_feet_push(walking):
    pace = pace_of_hips(walking(), 30)
    assert pace.ratio == pytest.approx(1, abs=0.05) and pace.alike > 0.9
    assert same_unit(pace) == (1.0, None)


@pytest.mark.parametrize("factor", [100, 1000, 0.01, 0.001])
def test_another_unit_is_mended(walking, factor):
    motion = walking()
    mend, note = same_unit(pace_of_hips(moved(motion, factor), 30))
    assert mend == pytest.approx(1 / factor)
    assert "feet would slide" in note
    again = moved(moved(motion, factor), mend)
    assert again.positions["head"] == pytest.approx(motion.positions["head"])


@pytest.mark.parametrize("factor", [3, 0.2, 30])
def test_sliding_feet_are_told(walking, factor):
    mend, note = same_unit(pace_of_hips(moved(walking(), factor), 30))
    assert mend == 1.0 and "feet slide" in note


def test_who_walks_on_the_spot_or_not_at_all_is_not_doubted(walking):
    assert same_unit(pace_of_hips(moved(walking(), 0.0), 30)) == (1.0, None)
    assert pace_of_hips(walking(frames=2), 30) is None
    assert same_unit(Pace(ratio=0.05, alike=0.1)) == (1.0, None)
