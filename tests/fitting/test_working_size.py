from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from silpose.core.pose_space import ANGLES
from silpose.fitting import BodyFitter
from silpose.fitting.geometry import geometry_of
from silpose.fitting.parameters import ANGLES as FREE_OF_OTHERS
from silpose.fitting.parameters import PARAMETERS
from silpose.fitting.working_size import WorkingSize, expected_height, seen_height
from silpose.silhouette import Camera, render


@settings(deadline=None)
@given(st.integers(1, 2000), st.integers(1, 2000), st.floats(0, 4000))
def test_a_person_is_about_as_tall_at_any_size(height, width, tall):
    size = WorkingSize.for_person(Camera(height=height, width=width), tall)
    assert 1 <= size.height <= height and 1 <= size.width <= width
    assert 0 < size.reduction <= 1 <= size.enlargement
    if 10 < tall <= height and height > 20:
        assert 150 < tall * size.factor < 250


def test_the_default_camera_needs_no_change():
    camera = Camera()
    size = WorkingSize.for_person(camera, expected_height(camera))
    assert size == (256, 256, 1.0, 1.0)


@pytest.mark.parametrize("side", [64, 160, 256, 900])
def test_contours_are_alike_at_any_size(body, walk, side):
    x, _ = walk
    (mask,) = render(body, Camera(width=side, height=side), ANGLES.rotations(x[:1]))
    camera = Camera(width=side, height=side)
    size = WorkingSize.for_person(camera, expected_height(camera))
    contour = size.contour(size.mask(mask))
    assert np.ptp(contour.pixels[:, 1]) == pytest.approx(196 * size.factor * side / 256, abs=6)
    assert 130 < len(contour.pixels) < 420
    np.testing.assert_allclose(np.linalg.norm(contour.normals, axis=1), 1)


@pytest.mark.parametrize("side", [64, 256, 900])
def test_the_overlap_of_the_true_body_is_whole(body, walk, side):
    x, _ = walk
    camera = Camera(width=side, height=side)
    (mask,) = render(body, camera, ANGLES.rotations(x[:1]))
    size = WorkingSize.for_person(camera, expected_height(camera))
    view = BodyFitter(body, camera, None).view
    angles = np.deg2rad(ANGLES.angles(x[0]))
    of = np.zeros(3), geometry_of(body), view
    assert size.overlap(size.mask(mask), angles, *of) > 0.97
    free = np.zeros(PARAMETERS)
    free[:FREE_OF_OTHERS], free[FREE_OF_OTHERS] = angles, 20.0
    moved = np.roll(mask, round(20 / size.factor), axis=1)
    assert size.overlap(size.mask(moved), free, *of) > 0.9


def test_the_size_follows_a_person_who_comes_near():
    camera = Camera(width=800, height=800)
    mask = np.zeros((800, 800), np.uint8)
    mask[100:300, 350:400] = 1
    size = WorkingSize.for_person(camera, 200)
    assert size.followed(camera, mask) is size
    mask[100:700] = mask[100]
    assert size.followed(camera, mask).factor == pytest.approx(0.35, abs=0.01)
    assert size.followed(camera, 0 * mask) is size
    assert seen_height([mask, 0 * mask]) == 600
    assert seen_height([0 * mask]) is None


def joint_error(x, other):
    apart = ANGLES.joints(x)[:, 1:18] - ANGLES.joints(other)[:, 1:18]
    return 1000 * np.linalg.norm(apart, axis=-1).mean()


@pytest.mark.parametrize(("height", "width"), [(64, 44), (128, 88), (720, 1280)])
def test_masks_of_any_size_are_fitted_as_well(body, prior, walk, estimated, height, width):
    x, _ = walk
    errors = []
    for side in ((height, width), (256, 256)):
        camera = Camera(height=side[0], width=side[1])
        masks = list(render(body, camera, ANGLES.rotations(x[:6])))
        fit = BodyFitter(body, camera, prior).fit(masks, estimated[:6])
        assert set(fit.state) == {"fitted"}
        errors.append(joint_error(fit.x, x[:6]))
    assert errors[0] < 1.5 * errors[1] + 5


def test_shifts_are_in_pixels_of_the_masks(body, prior, walk, estimated):
    x, _ = walk
    for side in (128, 512):
        camera = Camera(height=side, width=side)
        masks = [
            np.roll(m, side // 16, axis=1) for m in render(body, camera, ANGLES.rotations(x[:4]))
        ]
        fitter = BodyFitter(body, camera, prior)
        fit = replace(fitter, camera_is="estimated").fit(masks, estimated[:4])
        assert np.median(fit.shift[:, 0]) == pytest.approx(side / 16, rel=0.3)
