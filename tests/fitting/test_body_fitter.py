import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.fitting import BodyFitter
from silpose.silhouette import Body, Camera, render


def joint_error(x, other):
    apart = ANGLES.joints(x)[:, 1:18] - ANGLES.joints(other)[:, 1:18]
    return 1000 * np.linalg.norm(apart, axis=-1).mean()


@pytest.mark.parametrize("whole_take", [False, True])
def test_a_fit_repairs_most_of_an_estimate(body, camera, prior, walk, estimated, whole_take):
    x, masks = walk
    fit = BodyFitter(body, camera, prior, whole_take=whole_take).fit(masks, estimated)
    assert joint_error(fit.x, x) < 0.6 * joint_error(estimated, x)
    assert fit.iou.mean() > 0.94
    assert set(fit.state) == {"fitted"}


def test_a_better_start_among_others_is_found(body, camera, prior, walk, estimated):
    x, masks = walk
    turned = ANGLES.angles(estimated)
    turned[:, 0] += 180
    starts = ANGLES.from_angles(turned)
    fitter = BodyFitter(body, camera, prior, whole_take=False)
    alone = fitter.fit(masks, starts)
    helped = fitter.fit(masks, estimated, others=estimated[:, None])
    assert joint_error(helped.x, x) < joint_error(alone.x, x)


def test_a_blank_mask_and_a_missing_start_are_rows_of_nan(body, camera, prior, walk, estimated):
    _, masks = walk
    masks = [mask * (frame != 3) for frame, mask in enumerate(masks)]
    starts = estimated.copy()
    starts[7] = np.nan
    fit = BodyFitter(body, camera, prior).fit(masks, starts)
    missing = np.isnan(fit.x).any(axis=1)
    assert list(np.flatnonzero(missing)) == [3, 7]
    assert [fit.state[frame] for frame in (3, 7)] == ["blank", "blank"]
    assert np.isfinite(fit.x[~missing]).all()


def test_a_camera_that_is_not_known_is_estimated(body, prior, walk, estimated):
    x, _ = walk
    real = Camera(width=160, height=160, distance=4.0, elevation=7.0)
    masks = [np.roll(m, (5, -12), axis=(0, 1)) for m in render(body, real, ANGLES.rotations(x))]
    expected = Camera(width=160, height=160)
    fit = BodyFitter(body, expected, prior, camera_is="estimated").fit(masks, estimated)
    assert np.median(fit.iou) > 0.92
    assert np.median(fit.scale) == pytest.approx(4.5 / 4.0, rel=0.05)
    assert np.median(fit.shift, axis=0) == pytest.approx([-12, 5], abs=3)
    assert joint_error(fit.x, x) < joint_error(estimated, x)


def test_a_shape_that_is_not_known_is_estimated(camera, prior, walk, estimated):
    x, _ = walk
    heavy = Body("convex", level=2, shape=[0, -3, 0, 0, 0, 0, 0, 0, 0, 0])
    masks = list(render(heavy, camera, ANGLES.rotations(x)))
    mean = Body("convex", level=2)
    known, told = (
        BodyFitter(mean, camera, prior, shape_is=s).fit(masks, estimated)
        for s in ("known", "estimated")
    )
    assert told.iou.mean() > known.iou.mean() + 0.01
    assert told.shape[1] < -1


def test_what_does_not_belong_together_is_refused(body, camera, prior, walk, estimated):
    _, masks = walk
    fitter = BodyFitter(body, camera, prior)
    with pytest.raises(InputError, match="12 masks, 11 starts"):
        fitter.fit(masks, estimated[:11])
    with pytest.raises(InputError, match=r"shape \(20, 30\).*width=30, height=20"):
        fitter.fit([np.ones((20, 30))] * 12, estimated)
    with pytest.raises(InputError, match="no frame has"):
        fitter.fit([np.zeros((160, 160))] * 12, estimated)
    with pytest.raises(InputError, match="no rigid links"):
        BodyFitter(Body("wooden"), camera, prior).fit(masks, estimated)


def test_coverage_is_what_the_covariance_says(body, camera, prior, walk, estimated):
    x, masks = walk
    fit = BodyFitter(body, camera, prior, whole_take=False).fit(masks, estimated)
    deviation = np.sqrt(np.diagonal(fit.covariance, axis1=1, axis2=2))
    within = ANGLES.angle_errors(x, fit.x) < 1.645 * deviation
    assert 0.75 < within.mean() < 0.99
