from time import perf_counter

import numpy as np
import pytest
from synthetic import swinging

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.fitting import BodyFitter, FitterStream
from silpose.silhouette import Camera, render


def joint_error(x, other):
    apart = ANGLES.joints(x)[:, 1:18] - ANGLES.joints(other)[:, 1:18]
    return 1000 * np.linalg.norm(apart, axis=-1).mean()


def run(fitter, masks, starts, **options):
    stream = FitterStream(fitter, **options)
    x, states = zip(*(stream.step(m, s) for m, s in zip(masks, starts, strict=True)), strict=True)
    return np.stack(x), list(states)


@pytest.fixture
def fitter(body, camera, prior):
    return BodyFitter(body, camera, prior)


def test_estimates_are_repaired_frame_by_frame(fitter, walk, estimated):
    x, masks = walk
    fitted, states = run(fitter, masks, estimated)
    assert joint_error(fitted, x) < 0.5 * joint_error(estimated, x)
    assert set(states) == {"tracking"}


def test_overlap_and_covariance_are_those_of_the_last_frame(fitter, walk, estimated):
    stream = FitterStream(fitter)
    assert np.isnan(stream.iou)
    stream.step(walk[1][0], estimated[0])
    assert stream.iou > 0.9
    deviation = np.sqrt(np.diag(stream.covariance))
    assert (deviation > 0).all() and (deviation < 15).all()
    stream.step(0 * walk[1][0])
    assert np.isnan(stream.iou) and np.isnan(stream.covariance).all()


def test_without_an_estimate_the_last_fit_leads_on(fitter, walk, estimated):
    x, masks = walk
    nothing = np.full(55, np.nan)
    fitted, states = run(fitter, masks, [estimated[0], *[nothing] * 11])
    assert set(states) == {"tracking"}
    assert joint_error(fitted, x) < joint_error(estimated, x)


def test_a_person_is_lost_and_recovered(fitter, walk, estimated):
    _, masks = walk
    masks = [mask * (frame not in (0, 4, 5)) for frame, mask in enumerate(masks)]
    fitted, states = run(fitter, masks, estimated)
    assert np.isnan(fitted[0]).all() and states[0] == "starting"
    assert states[1:4] == ["tracking"] * 3
    assert states[4:7] == ["lost", "lost", "recovered"] and states[7] == "tracking"
    np.testing.assert_allclose(fitted[4], fitted[3])


def test_what_is_no_person_is_lost(fitter, walk, estimated):
    _, masks = walk
    bar = np.zeros_like(masks[0])
    bar[60:80, 5:155] = 1
    stream = FitterStream(fitter)
    stream.step(masks[0], estimated[0])
    x, state = stream.step(bar, estimated[1])
    assert state == "lost" and np.isfinite(x).all() and stream.iou < 0.6
    assert stream.step(masks[2], estimated[2])[1] == "recovered"


def test_a_single_wrong_estimate_does_not_turn_the_person_around(fitter, walk, estimated):
    x, masks = walk
    wrong = estimated.copy()
    wrong[6] = ANGLES.from_angles(ANGLES.angles(estimated[6]) + 180 * (np.arange(54) == 0))
    fitted, _ = run(fitter, masks, wrong)
    assert ANGLES.angle_errors(fitted, x)[:, 0].max() < 20


def test_estimates_that_agree_with_the_masks_end_a_wrong_start(body, fitter, camera, prior):
    x = ANGLES.from_angles(swinging(10, turns=0.1))
    masks = list(render(body, camera, ANGLES.rotations(x)))
    starts = x.copy()
    starts[0] = ANGLES.from_angles(ANGLES.angles(x[0]) + 120 * (np.arange(54) == 0))
    fitted, _ = run(fitter, masks, starts)
    assert ANGLES.angle_errors(fitted, x)[-3:, 0].max() < 20


def test_an_unknown_camera_is_followed(body, prior, walk, estimated):
    x, _ = walk
    real = Camera(width=160, height=160, distance=4.0)
    masks = [
        np.roll(mask, (5, 2 * frame - 10), axis=(0, 1))
        for frame, mask in enumerate(render(body, real, ANGLES.rotations(x)))
    ]
    camera = Camera(width=160, height=160)
    fitted, states = run(BodyFitter(body, camera, prior, camera_is="estimated"), masks, estimated)
    assert states[-1] == "tracking"
    assert joint_error(fitted, x) < 0.75 * joint_error(estimated, x)


def test_a_step_takes_no_longer_than_a_frame(fitter, walk, estimated):
    stream, seconds = FitterStream(fitter), []
    for mask, start in zip(walk[1], estimated, strict=True):
        began = perf_counter()
        stream.step(mask, start)
        seconds.append(perf_counter() - began)
    assert np.median(seconds) < 0.06  # a fifth of this on an idle machine


def test_a_mask_of_many_specks_costs_little_more(fitter, walk, estimated):
    noise = (np.random.default_rng(0).random(walk[1][0].shape) > 0.5).astype(np.uint8)
    stream = FitterStream(fitter)
    stream.step(walk[1][0], estimated[0])
    began = perf_counter()
    assert stream.step(noise, estimated[1])[1] == "lost"
    assert perf_counter() - began < 1  # and nothing is compiled anew


def test_a_pose_that_drifted_away_comes_back_to_the_estimates(body, fitter, camera):
    x = ANGLES.from_angles(swinging(16, turns=0.2))
    masks = list(render(body, camera, ANGLES.rotations(x)))
    nothing = np.full(55, np.nan)
    drifted = ANGLES.from_angles(ANGLES.angles(x[0]) + 60 * (np.arange(54) == 0))
    fitted, _ = run(fitter, masks, [drifted, *[nothing] * 7, *x[8:]])
    assert ANGLES.distance(fitted, x)[10:].max() < 4


def test_masks_of_another_size_are_refused(fitter):
    with pytest.raises(InputError, match=r"shape \(20, 30\) where the camera's is \(160, 160\)"):
        FitterStream(fitter).step(np.ones((20, 30), np.uint8))


def test_a_frame_that_follows_is_not_more_certain_than_what_is_new_in_it(fitter, walk, estimated):
    stream = FitterStream(fitter)
    spread = []
    for mask, start in zip(walk[1], estimated, strict=True):
        stream.step(mask, start)
        spread.append(np.sqrt(np.diag(stream.covariance)).mean())
    assert spread[-1] > 0.6 * spread[0]


def test_the_confidence_is_that_of_the_last_frame(fitter, walk, estimated):
    stream = FitterStream(fitter)
    assert stream.confidence == 0
    stream.step(walk[1][0], estimated[0])
    assert stream.confidence > 0.8 and np.isfinite(stream.evidence).all()
    stream.step(0 * walk[1][0])
    assert stream.confidence == 0 and np.isnan(stream.evidence).all()
