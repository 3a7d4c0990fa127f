import pytest

from silpose.tracking import STATES
from silpose.tracking.track import SETTLED, UNCERTAIN, next_state, over_a_break


@pytest.mark.parametrize(
    ("state", "lost", "heading_norm", "then"),
    [
        ("starting", False, 0.5, "starting"),
        ("starting", True, 0.9, "starting"),
        ("starting", False, 0.9, "tracking"),
        ("tracking", False, 0.5, "tracking"),
        ("tracking", False, 0.1, "lost"),
        ("tracking", True, 0.9, "lost"),
        ("lost", False, 0.5, "lost"),
        ("lost", False, 0.9, "recovered"),
        ("recovered", False, 0.5, "tracking"),
        ("recovered", True, 0.9, "lost"),
    ],
)
def test_a_track_goes_from_state_to_state(state, lost, heading_norm, then):
    assert next_state(state, lost, heading_norm) == then
    assert {state, then} <= set(STATES)


def test_a_track_is_found_at_a_higher_norm_than_it_is_lost():
    between = (SETTLED + UNCERTAIN) / 2
    assert next_state("tracking", False, between) == "tracking"
    assert next_state("lost", False, between) == "lost"


@pytest.mark.parametrize(
    ("state", "before", "seconds", "then"),
    [
        ("recovered", "tracking", 0.2, "tracking"),
        ("recovered", "recovered", 0.2, "tracking"),
        ("recovered", "tracking", 2.0, "recovered"),
        ("recovered", "lost", 0.2, "recovered"),
        ("recovered", None, 0.0, "recovered"),
        ("lost", "tracking", 0.2, "lost"),
    ],
)
def test_after_a_short_break_a_track_goes_on(state, before, seconds, then):
    assert over_a_break(state, before, seconds) == then
