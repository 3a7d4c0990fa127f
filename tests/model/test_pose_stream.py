from dataclasses import replace

import numpy as np
import pytest
from small_model import tracking_and_fitting

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.model import Poses, PoseStream

pytestmark = pytest.mark.filterwarnings("ignore:this model was trained without")


@pytest.fixture(scope="module")
def model(sequence, body, camera):
    return tracking_and_fitting(sequence, body, camera)


def test_random_frames_may_be_dropped(model, sequence):
    kept = np.random.default_rng(0).random(40) < 0.7
    stream = model.stream()
    steps = [
        stream.step(mask, time)
        for mask, time, keep in zip(sequence.masks, np.arange(40) / 15, kept, strict=True)
        if keep
    ]
    poses = Poses.concatenate(steps)
    np.testing.assert_allclose(poses.time, (np.arange(40) / 15)[kept])
    every = model.track(sequence.masks, frames_per_second=15)
    own = ANGLES.distance(sequence.x[kept], poses.x).mean()
    assert own < 1.5 * ANGLES.distance(sequence.x, every.x).mean() + 0.5


def test_a_faster_camera_is_followed(model, sequence):
    stream = model.stream(frames_per_second=60)
    steps = [stream.step(mask) for mask in np.repeat(sequence.masks[:15], 4, axis=0)]
    poses = Poses.concatenate(steps)
    assert poses.time[-1] == pytest.approx(59 / 60)
    truth = np.repeat(sequence.x[:15], 4, axis=0)
    assert ANGLES.distance(truth, poses.x)[20:].mean() < 6


def test_every_encoding_is_one_mask(model, sequence):
    answers = []
    for encode in (lambda m: m, lambda m: 255 * m, lambda m: m.astype(bool), lambda m: m * 0.7):
        stream = model.stream()
        answers.append([stream.step(encode(mask)).x for mask in sequence.masks[:4]])
    for other in answers[1:]:
        np.testing.assert_array_equal(other, answers[0])


def test_dropped_frames_are_time_for_a_fit_too(model, sequence):
    stream = model.stream(fit=True)
    steps = [stream.step(sequence.masks[k], k / 15) for k in (0, 1, 2, 3, 7, 8, 9)]
    assert [step.state[0] for step in steps][1:] == ["tracking"] * 6
    assert Poses.concatenate(steps).iou.min() > 0.75


def test_without_a_tracker_each_frame_is_fitted_by_itself(model, sequence):
    stream = replace(model, tracker=None).stream(fit=True)
    assert np.isnan(stream.step(0 * sequence.masks[0]).x).all()
    assert np.isfinite(stream.step(sequence.masks[0]).x).all()


@pytest.mark.parametrize("tracked", [True, False])
def test_time_goes_on(model, sequence, tracked):
    stream = PoseStream(model if tracked else replace(model, tracker=None))
    stream.step(sequence.masks[0], 1.0)
    for time in (1.0, 0.5, np.nan, np.inf, "a"):
        with pytest.raises(InputError, match=r"not after|must be a finite number"):
            stream.step(sequence.masks[1], time)
    assert stream.step(sequence.masks[1]).time[0] == pytest.approx(1 + 1 / 15)


def test_what_is_no_person_is_not_fitted(model, sequence):
    stream = model.stream(fit=True)
    for mask in sequence.masks[:4]:
        stream.step(mask)
    poses = stream.step(np.ones_like(sequence.masks[0]))  # the foreground fills the frame
    assert poses.state == ["lost"] and np.isnan(poses.iou[0]) and poses.facts.filled[0]
    masks = [*sequence.masks[:3], np.ones_like(sequence.masks[0])]
    poses = model.predict(masks, fit=True, frames_per_second=15)
    assert poses.state[3] == "blank" and np.isnan(poses.x[3]).all()
