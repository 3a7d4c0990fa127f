"""Masks and starts that are nothing like a person's: a state, finite values, in finite time."""

from time import perf_counter

import cv2
import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.evaluation import right_poses
from silpose.fitting import BodyFitter, FitterStream
from silpose.silhouette import FOREIGN, Body, Camera, foreign_shape, render

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


def joint_error(x, other):
    apart = ANGLES.joints(x)[:, 1:18] - ANGLES.joints(other)[:, 1:18]
    return 1000 * np.linalg.norm(apart, axis=-1).mean()


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
        assert ((fit.confidence >= 0) & (fit.confidence <= 1)).all()
        for state, confidence in zip(fit.state, fit.confidence, strict=True):
            assert (state == "fitted") == (confidence >= 0.5)
        assert np.isfinite(fit.shape).all()
        assert ((fit.scale[seen] > 0) & (fit.scale[seen] < 1000)).all()
        yield fit


@pytest.mark.parametrize("what", NO_PERSON)
def test_what_is_no_person_is_fitted_poorly(what, body, camera, prior, walk, estimated):
    """In the midst of a take, and its neighbours do not suffer."""
    _, masks = walk
    masks = [*masks[:3], NO_PERSON[what], *masks[4:6]]
    for fit in fits_to(masks, body, camera, prior, estimated[:6]):
        assert fit.state[3] in ("poor", "blank")
        assert set(fit.state[:3] + fit.state[4:]) == {"fitted"}


@pytest.mark.parametrize("what", ["a disc", "noise", "a tiny disc"])
def test_a_take_without_a_person_is_fitted_poorly(what, body, camera, prior, estimated):
    for fit in fits_to([NO_PERSON[what]] * 4, body, camera, prior, estimated[:4]):
        assert set(fit.state) == {"poor"}


# A ball on a post is what a person who stands still looks like.
UNLIKE = [kind for kind in FOREIGN if kind != "tree"]


@pytest.mark.parametrize("kind", UNLIKE)
def test_no_shape_but_a_persons_is_fitted(kind, body, camera, prior, estimated):
    """Even where the body's shape, its size and its place are free."""
    rng = np.random.default_rng(1)
    for _ in range(2):
        mask = foreign_shape(SIZE, SIZE, 120, rng, kind)
        for fit in fits_to([mask] * 2, body, camera, prior, estimated[:2]):
            assert "fitted" not in fit.state


@pytest.mark.parametrize("kind", UNLIKE)
def test_live_no_shape_but_a_persons_is_followed(kind, body, camera, prior, estimated):
    mask = foreign_shape(SIZE, SIZE, 120, np.random.default_rng(1), kind)
    for knowledge in ("known", "estimated"):
        fitter = BodyFitter(body, camera, prior, camera_is=knowledge, shape_is=knowledge)
        stream, followed = FitterStream(fitter), 0
        for start in estimated[:6]:
            x, state = stream.step(mask, start)
            assert np.isfinite(x).all() and 0 <= stream.confidence <= 1
            assert (stream.confidence >= 0.5) == (state in ("tracking", "recovered"))
            followed += stream.confidence >= 0.5
        assert followed <= 1


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
        assert fit.confidence.mean() < right.confidence.mean()


def test_a_camera_20_degrees_off_is_found_where_it_is_free(body, prior, walk, estimated):
    x, _ = walk
    above = Camera(width=SIZE, height=SIZE, elevation=25.0)
    masks = list(render(body, above, ANGLES.rotations(x[:4])))
    known, free = fits_to(masks, body, Camera(width=SIZE, height=SIZE), prior, estimated[:4])
    assert free.elevation > 6
    assert joint_error(free.x, x[:4]) < joint_error(known.x, x[:4])


def small(x):
    """A slight person farther away."""
    slight = Body("convex", level=2, shape=[-2.5, 1, 0, 0, 0, 0, 0, 0, 0, 0])
    return list(render(slight, Camera(width=SIZE, height=SIZE, distance=6.0), ANGLES.rotations(x)))


def child(x):
    """A head as large as it is in a fifth of the height, and short legs."""
    return [in_bands(mask, {0.14: 1.7, 0.5: 1.0, 1.0: 0.75}) for mask in small(x)]


def in_bands(mask, factors):
    """Enlarge bands of a person's height, given where each ends, about the person's middle."""
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    middle, tall, top = int(columns.mean()), len(rows), rows[0]
    bands, start = [], 0.0
    for end, factor in factors.items():
        band = mask[top + round(start * tall) : top + round(end * tall)]
        wide = max(1.0, factor)  # legs get shorter, not thinner
        into = np.array([[wide, 0, middle * (1 - wide)], [0, factor, 0]])
        bands.append(cv2.warpAffine(band, into, (SIZE, round(factor * len(band)))))
        start = end
    figure = np.concatenate(bands)[: SIZE - top]
    return np.pad(figure, ((top, SIZE - top - len(figure)), (0, 0)))


def skirted(masks):
    """Between hips and shins nothing of the legs is seen apart."""
    dressed = []
    for mask in masks:
        rows = np.flatnonzero(mask.any(axis=1))
        ends = [rows[0] + round(share * len(rows)) for share in (0.5, 0.8)]
        own = np.argwhere(mask[slice(*ends)])[:, ::-1] + [0, ends[0]]
        hull = cv2.convexHull(own.astype(np.int32))
        dressed.append(cv2.fillConvexPoly(mask.copy(), hull, 1))
    return dressed


SMALL = pytest.mark.xfail(reason="told a wrong shape and camera, it is sure by about a half")


@pytest.mark.parametrize(
    "who", [pytest.param("small", marks=SMALL), pytest.param("child", marks=SMALL), "skirt"]
)
def test_whoever_is_unlike_the_body_is_fitted_rightly_or_poorly(
    who, body, camera, prior, walk, estimated
):
    x, masks = walk[0][:4], walk[1][:4]
    shown = {"small": small, "child": child}[who](x) if who != "skirt" else skirted(masks)
    for fit in fits_to(shown, body, camera, prior, estimated[:4]):
        assert (right_poses(ANGLES, x, fit.x) | (fit.confidence < 0.5)).all()


def test_frames_without_an_estimate_start_from_the_others(body, camera, prior, walk, estimated):
    x, masks = walk
    starts = np.full_like(estimated, np.nan)
    starts[:6] = estimated[:6]
    fit = BodyFitter(body, camera, prior).fit(masks, starts, others=estimated[:, None])
    assert "blank" not in fit.state
    assert ANGLES.distance(x[6:], fit.x[6:]).mean() < ANGLES.distance(x[6:], estimated[6:]).mean()
