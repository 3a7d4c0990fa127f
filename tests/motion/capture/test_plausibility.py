import numpy as np
import pytest

from silpose.motion.capture.plausibility import (
    Gait,
    doubts_of_build,
    doubts_of_gait,
    doubts_of_jumps,
    doubts_of_stillness,
    measure_gait,
    our_leg,
)
from silpose.motion.capture.source_motion import SourceMotion


def test_speed_and_strides_of_a_walk(walking):
    gait = measure_gait(walking(frames=120), 30)
    assert gait.speed == pytest.approx(1.4, abs=0.2)
    assert gait.strides == pytest.approx(0.9, abs=0.03)
    assert measure_gait(walking(frames=2)[:1], 30) == Gait(0.0, None)


@pytest.mark.parametrize(("speed", "strides"), [(0.3, 0.5), (1.3, 0.9), (2.0, 1.1), (5.0, 1.5),
                                                (0.0, None), (3.0, None)])  # fmt: skip
def test_how_people_walk_and_run_is_not_doubted(speed, strides):
    assert doubts_of_gait(Gait(speed, strides), 30) == []


@pytest.mark.parametrize(
    ("gait", "rate", "likely"),
    [
        (Gait(4.8, 3.8), 120, 30),
        (Gait(2.4, 1.9), 60, 30),
        (Gait(0.3, 0.22), 30, 120),
        (Gait(7.0, None), 120, 20),
    ],
)
def test_a_frame_rate_that_cannot_be_is_named_with_a_likely_one(gait, rate, likely):
    (doubt,) = doubts_of_gait(gait, rate)
    assert f"{gait.speed:.1f} m" in doubt and f"motion.frame_rate={likely} " in doubt


def test_a_speed_that_nobody_has_is_doubted_with_its_unit():
    (doubt,) = doubts_of_gait(Gait(120.0, 0.9), 30)
    assert "120.0 m" in doubt and "unit of its bones" in doubt


def test_who_does_not_move_is_doubted(walking):
    still = SourceMotion({}, {j: np.repeat(p[:1], 13, 0) for j, p in walking().positions.items()})
    assert "still in all of its 13 frames" in doubts_of_stillness(still)[0]
    assert doubts_of_stillness(still[:9]) == [] == doubts_of_stillness(walking())


def test_jumps_are_named_with_their_frame(walking):
    motion = walking()
    assert doubts_of_jumps(motion, 30, 0) == []
    later = (np.arange(60) >= 40)[:, None] * 2.0
    jumping = SourceMotion({}, {joint: p + later for joint, p in motion.positions.items()})
    (doubt,) = doubts_of_jumps(jumping, 30, 1)
    assert "jumps 3." in doubt and "frame 41:" in doubt


def test_a_persons_build_is_not_doubted(walking):
    assert doubts_of_build(walking(), None) == [] == doubts_of_build(walking(), 1.0)


def test_legs_of_another_unit_are_told(walking):
    assert "its legs are 0.0084" in doubts_of_build(walking(seed=1), 0.01)[0].replace(
        "0.00", "0.00"
    )


def test_a_thumb_is_no_forearm(walking):
    motion = walking()
    places = dict(motion.positions)
    for side in ("left", "right"):
        wrist, elbow = (places[f"{side}_{joint}"] for joint in ("wrist", "elbow"))
        places[f"{side}_wrist"] = elbow + 0.1 * (wrist - elbow)
    (doubt,) = doubts_of_build(SourceMotion({}, places), None)
    assert doubt.startswith("upper arm over forearm is 1") and "motion.joints" in doubt


def test_our_legs_are_those_of_the_mannequin():
    assert our_leg() == pytest.approx(0.78, abs=0.01)
