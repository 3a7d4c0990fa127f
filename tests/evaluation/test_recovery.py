import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.dataset import Take
from silpose.evaluation import (
    FailureSequence,
    FailureTrial,
    blank_trials,
    cut_trials,
    heading_errors,
)

RATE = 15.0


def circle(frames):
    """Poses of someone who turns by 6 degrees a frame."""
    angles = np.zeros((frames, 54))
    angles[:, 0] = np.arange(frames) * 6.0 % 360 - 180
    return ANGLES.from_angles(angles)


def late(trial, frames):
    """A track that faces the other way until some frames after the failure."""
    opposite = trial.x * np.where(np.arange(trial.x.shape[1]) < 2, -1, 1)
    wrong = np.arange(len(trial.x)) < trial.end + frames
    return lambda z: np.where(wrong[:, None], opposite, trial.x)


@pytest.mark.parametrize("delay", [0, 3, 6, 12])
def test_recovery_takes_as_long_as_the_track_is_late(delay):
    x = circle(120)
    trial = FailureTrial.blank(x, x, at=60, frames=20, rate=RATE)
    assert np.isnan(trial.z).any(axis=1).sum() == 20
    assert np.isfinite(trial.z[trial.end :]).all()
    seconds = trial.recovery_seconds(ANGLES, late(trial, delay), RATE)
    assert seconds == pytest.approx(delay / RATE)


def test_a_track_that_is_never_back_does_not_recover():
    x = circle(120)
    trial = FailureTrial.blank(x, x, at=60, frames=20, rate=RATE)
    assert trial.recovery_seconds(ANGLES, lambda z: np.roll(trial.x, 10, axis=0), RATE) == np.inf


def test_a_single_frame_that_is_met_by_chance_is_no_recovery():
    x = circle(120)
    trial = FailureTrial.blank(x, x, at=60, frames=20, rate=RATE)
    track = late(trial, 10)(trial.z)
    track[trial.end + 2] = trial.x[trial.end + 2]
    assert trial.recovery_seconds(ANGLES, lambda z: track, RATE) == pytest.approx(10 / RATE)


def test_a_failure_comes_after_two_seconds_and_is_followed_for_two():
    x = circle(200)
    for trial in blank_trials([(x, x), (x, x)], 10, 7, RATE):
        assert trial.end == 30 + 10
        assert len(trial.x) == 30 + 10 + 30
    assert len(blank_trials([(x, x)], 10, 7, RATE)) == 7
    assert blank_trials([(x[:50], x[:50])], 10, 7, RATE) == []


def test_cuts_lead_elsewhere():
    one, other = circle(100), circle(100)[::-1]
    for trial in cut_trials([(one, one), (other, other)], 10, RATE, seed=0):
        assert len(trial.x) == trial.end + 30
    for trial in cut_trials([(one, one)], 10, RATE, seed=0):
        before, after = trial.x[trial.end - 1 :][:1], trial.x[trial.end :][:1]
        assert heading_errors(ANGLES, before, after) > 10


def test_the_same_seed_makes_the_same_cuts():
    x = circle(150)
    first, again, other = ([t.x for t in cut_trials([(x, x)], 5, RATE, seed)] for seed in (0, 0, 1))
    assert all(np.array_equal(a, b) for a, b in zip(first, again, strict=True))
    assert not all(np.array_equal(a, b) for a, b in zip(first, other, strict=True))


def test_a_sequence_is_blank_for_a_while_and_then_cut():
    x, masks = circle(90), np.ones((90, 4, 4), np.uint8)
    take = Take("walk", "someone", RATE, x, masks, np.zeros((90, 3)))
    sequence = FailureSequence.of(take, x.copy(), blank_frames=10)
    blank = np.isnan(sequence.z).any(axis=1)
    assert blank.nonzero()[0].tolist() == list(range(30, 40))
    np.testing.assert_array_equal(~blank, sequence.take.masks.any(axis=(1, 2)))
    np.testing.assert_array_equal(sequence.take.x[: sequence.cut], x[:60])
    np.testing.assert_array_equal(sequence.take.x[sequence.cut :], x[15:45])
    assert np.isfinite(take.x).all() and take.masks.all()  # the take itself stays as it is
