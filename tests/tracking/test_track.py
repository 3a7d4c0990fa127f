import pytest

from silpose.tracking import STATES
from silpose.tracking.track import SETTLED, UNCERTAIN, next_state


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
