import numpy as np
import pytest
from gait_truth import contacts, world_feet

from silpose.core.pose_space import ANGLES
from silpose.evaluation.gait import Walk, gait_report


def times(report, side, strike):
    return np.array([e.time for e in report.events if (e.side, e.strike) == (side, strike)])


@pytest.mark.parametrize("every", [4, 8])
def test_events_are_those_of_contact_with_the_ground(straight, report_of, every):
    report, feet = report_of(straight, every), world_feet(straight)
    speed = np.linalg.norm(straight.root_position[-1] - straight.root_position[0]) / 8
    for side in ("left", "right"):
        strikes, _ = contacts(feet[f"{side}_heel"], 120.0, speed)
        _, offs = contacts(feet[f"{side}_toes"], 120.0, speed)
        for found, true in (
            (times(report, side, True), strikes),
            (times(report, side, False), offs),
        ):
            gaps = np.abs(found[:, None] - true).min(axis=1)
            assert np.median(gaps) < 0.05
            assert len(found) >= len(true) - 2


def test_events_are_between_frames(straight, report_of):
    coarse, fine = report_of(straight, 8), report_of(straight, 1)
    for side in ("left", "right"):
        one, two = times(coarse, side, True), times(fine, side, True)
        assert np.abs(one[:, None] - two).min(axis=1).max() < 0.02  # a frame is 0.067 s


def test_uneven_times_give_the_same_events(straight):
    rng = np.random.default_rng(0)
    frames = np.sort(rng.choice(len(straight), len(straight) // 4, replace=False))
    report = gait_report(
        Walk.from_poses(
            ANGLES.from_angles(straight.angles[frames]),
            time=5.0 + frames / 120.0,
            path=straight.root_position[frames],
        )
    )
    even = gait_report(
        Walk.from_poses(
            ANGLES.from_angles(straight.angles),
            frames_per_second=120.0,
            path=straight.root_position,
        )
    )
    one, two = times(report, "left", True) - 5.0, times(even, "left", True)
    assert np.abs(one[:, None] - two).min(axis=1).max() < 0.03
