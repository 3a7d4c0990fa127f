"""Masks and starts that are nothing like a person's: a state, finite values, in finite time."""

from time import perf_counter

import cv2
import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.fitting import BodyFitter
from silpose.silhouette import Body, Camera, render

SIZE = 160


def disc(radius):
    return cv2.circle(np.zeros((SIZE, SIZE), np.uint8), (80, 80), radius, 1, -1)


def striped():
    mask = np.zeros((SIZE, SIZE), np.uint8)
    mask[::4] = 1
    return mask


def noise():
    return (np.random.default_rng(0).random((SIZE, SIZE)) < 0.5).astype(np.uint8)


def block():
    mask = np.zeros((SIZE, SIZE), np.uint8)
    mask[70:95, 20:45] = 1
    return mask


NO_PERSON = {
    "a disc": disc(40), "a tiny disc": disc(4), "a huge disc": disc(79), "stripes": striped(),
    "noise": noise(), "the full frame": np.ones((SIZE, SIZE), np.uint8),
    "a block": block(), "one pixel": disc(0),
}  # fmt: skip


def fits_to(masks, body, camera, prior, estimated):
    for choices in ({}, {"camera_is": "estimated", "shape_is": "estimated"}):
        started = perf_counter()
        fit = BodyFitter(body, camera, prior, **choices).fit(masks, estimated)
        assert perf_counter() - started < 60
        seen = np.array([state != "blank" for state in fit.state])
        assert np.isfinite(fit.x[seen]).all()
        assert np.isfinite(fit.covariance[seen]).all()
        assert (np.linalg.eigvalsh(fit.covariance[seen]) > 0).all()
        assert np.isfinite(fit.mode_weights).all()
        assert np.isfinite(fit.shape).all()
        assert ((fit.scale[seen] > 0) & (fit.scale[seen] < 1000)).all()
        yield fit


@pytest.mark.parametrize("what", NO_PERSON)
def test_what_is_no_person_is_fitted_poorly(what, body, camera, prior, walk, estimated):
    """In the midst of a take, and its neighbours do not suffer."""
    _, masks = walk
    masks = [*masks[:3], NO_PERSON[what], *masks[4:6]]
    known, free = fits_to(masks, body, camera, prior, estimated[:6])
    assert known.state[3] in ("poor", "blank")
    for fit in (known, free):
        assert set(fit.state[:3] + fit.state[4:]) == {"fitted"}


@pytest.mark.parametrize("what", ["a disc", "noise", "a tiny disc"])
def test_a_take_without_a_person_is_fitted_poorly(what, body, camera, prior, estimated):
    (known, free) = fits_to([NO_PERSON[what]] * 4, body, camera, prior, estimated[:4])
    assert set(known.state) == {"poor"}
    assert free.iou.max() < 0.9


def test_two_people_are_fitted_poorly(body, camera, prior, walk, estimated):
    _, masks = walk
    both = [mask | np.roll(mask, 45, axis=1) for mask in masks[:4]]
    known, _ = fits_to(both, body, camera, prior, estimated[:4])
    assert set(known.state) == {"poor"}


@pytest.mark.parametrize("cut", [slice(80, None), slice(None, 80)])
def test_half_a_person_overlaps_less(cut, body, camera, prior, walk, estimated):
    _, masks = walk
    halves = [mask.copy() for mask in masks[:4]]
    for half in halves:
        half[cut] = 0
    known, _ = fits_to(halves, body, camera, prior, estimated[:4])
    assert known.iou.max() < 0.85


def test_a_start_half_a_turn_off_is_less_likely_than_a_right_one(
    body, camera, prior, walk, estimated
):
    _, masks = walk
    angles = ANGLES.angles(estimated)
    angles[:, 0] += 180
    turned = ANGLES.from_angles(angles)
    for fit in fits_to(masks[:4], body, camera, prior, turned[:4]):
        right = BodyFitter(body, camera, prior).fit(masks[:4], estimated[:4])
        assert fit.iou.mean() < right.iou.mean()


def test_a_camera_20_degrees_off_shows_in_the_overlap(body, prior, walk, estimated):
    x, _ = walk
    above = Camera(width=SIZE, height=SIZE, elevation=25.0)
    masks = list(render(body, above, ANGLES.rotations(x[:4])))
    known, free = fits_to(masks, body, Camera(width=SIZE, height=SIZE), prior, estimated[:4])
    assert known.iou.mean() < 0.95
    assert free.elevation > 6


def test_a_child_and_a_skirt_are_fitted(body, camera, prior, walk, estimated):
    x, masks = walk
    child = Body("convex", level=2, shape=[-2.5, 1, 0, 0, 0, 0, 0, 0, 0, 0])
    far = Camera(width=SIZE, height=SIZE, distance=6.0)
    small = list(render(child, far, ANGLES.rotations(x[:4])))
    skirt = [
        cv2.fillConvexPoly(mask.copy(), np.array([[70, 80], [90, 80], [102, 125], [58, 125]]), 1)
        for mask in masks[:4]
    ]
    for worn in (small, skirt):
        for fit in fits_to(worn, body, camera, prior, estimated[:4]):
            assert len(fit.state) == 4


def test_frames_without_an_estimate_start_from_the_others(body, camera, prior, walk, estimated):
    x, masks = walk
    starts = np.full_like(estimated, np.nan)
    starts[:6] = estimated[:6]
    fit = BodyFitter(body, camera, prior).fit(masks, starts, others=estimated[:, None])
    assert "blank" not in fit.state
    assert ANGLES.distance(x[6:], fit.x[6:]).mean() < ANGLES.distance(x[6:], estimated[6:]).mean()
