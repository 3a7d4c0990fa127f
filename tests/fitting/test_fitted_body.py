import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.fitting import (
    SHAPES,
    BodyFitter,
    Fit,
    fitted_joints,
    fitted_silhouettes,
    standing_body_height,
)
from silpose.silhouette import Body


@pytest.fixture(scope="module")
def fitter(body, camera, prior):
    return BodyFitter(body, camera, prior)


def fit_of(x, camera, shape=None, shift=(0.0, 0.0), scale=1.0):
    frames = len(x)
    return Fit(
        x, np.zeros((frames, 54, 54)), np.ones(frames), np.ones(frames), ["fitted"] * frames,
        np.tile(shift, (frames, 1)), np.full(frames, scale), camera.elevation,
        np.zeros(SHAPES) if shape is None else shape, x[:, None], np.ones((frames, 1)),
        np.zeros((frames, 9)),
    )  # fmt: skip


def test_joints_are_those_of_the_skeleton_and_where_the_camera_sees_them(fitter, walk, camera):
    x, masks = walk
    places, pixels = fitted_joints(fitter, fit_of(x, camera))
    np.testing.assert_allclose(places, ANGLES.joints(x), atol=1e-4)
    np.testing.assert_allclose(pixels, camera.project(ANGLES.joints(x)), atol=0.05)
    for mask, joints in zip(masks, np.rint(pixels).astype(int), strict=True):
        assert mask[joints[1:4, 1], joints[1:4, 0]].all()  # the trunk is inside the silhouette


def test_shift_and_scale_move_joints_as_silhouettes(fitter, walk, camera):
    x, _ = walk
    fit = fit_of(x[:1], camera, shift=(12.0, -5.0), scale=0.7)
    _, pixels = fitted_joints(fitter, fit)
    _, usual = fitted_joints(fitter, fit_of(x[:1], camera))
    middle = (camera.width - 1) / 2
    np.testing.assert_allclose(pixels, middle + 0.7 * (usual - middle) + (12.0, -5.0), atol=1e-6)
    rows, columns = np.nonzero(fitted_silhouettes(fitter, fit)[0])
    assert columns.min() < pixels[0, 0, 0] < columns.max()
    assert rows.min() < pixels[0, 0, 1] < rows.max()


def test_frames_without_a_pose_have_no_joints(fitter, walk, camera):
    x = walk[0][:3].copy()
    x[1] = np.nan
    places, pixels = fitted_joints(fitter, fit_of(x, camera))
    assert np.isnan(places[1]).all() and np.isnan(pixels[1]).all()
    assert np.isfinite(places[[0, 2]]).all()


def test_a_taller_shape_stands_taller(fitter):
    usual = standing_body_height(fitter, np.zeros(SHAPES))
    assert usual == pytest.approx(1.72, abs=0.02)
    shape = np.eye(SHAPES)[0] * 2.0
    other = Body(level=2, shape=list(shape))
    built = np.ptp(other.pieces(np.tile(np.eye(3), (1, 18, 1, 1)))[..., 1])
    assert standing_body_height(fitter, shape) == pytest.approx(float(built), abs=5e-3)
    assert abs(standing_body_height(fitter, shape) - usual) > 0.05
