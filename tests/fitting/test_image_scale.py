import numpy as np
import pytest

from silpose.core.pose_space import ANGLES as SPACE
from silpose.fitting.contour import contour_of
from silpose.fitting.geometry import geometry_of
from silpose.fitting.image_scale import ImageScale
from silpose.fitting.parameters import ELEVATION, LOG_SCALE, SHIFT_X, SHIFT_Y
from silpose.silhouette import Camera, render


@pytest.fixture
def scale(body):
    return ImageScale(geometry_of(body))


def placed(scale, body, view, x, distance):
    """Parameters of the true pose, placed on a mask of it from some distance, moved by 9 and 4."""
    camera = Camera(width=160, height=160, distance=distance)
    (mask,) = render(body, camera, SPACE.rotations(x[:1]))
    contour = contour_of(np.roll(mask, (4, 9), axis=(0, 1)))
    return scale.placed(np.deg2rad(SPACE.angles(x[0])), np.zeros(3), contour, view)


def test_a_body_is_placed_where_its_contour_is(scale, body, view, walk):
    parameters = placed(scale, body, view, walk[0], 4.0)
    assert parameters[[SHIFT_X, SHIFT_Y]] == pytest.approx([9, 4], abs=2.5)
    assert parameters[LOG_SCALE] == pytest.approx(np.log(4.5 / 4.0), abs=0.05)


def test_the_scale_of_a_frame_is_that_of_those_before(scale, body, view, walk):
    for value in (0.1, 0.3):
        parameters = np.zeros(ELEVATION)
        parameters[LOG_SCALE] = value
        scale.add(parameters)
    assert placed(scale, body, view, walk[0], 4.0)[LOG_SCALE] == pytest.approx(0.2)


def test_the_scale_is_known_better_with_every_frame(scale):
    first = scale.precision_with(np.eye(54), 160)
    for _ in range(1000):
        scale.add(np.zeros(ELEVATION))
    later = scale.precision_with(np.eye(54), 160)
    assert first.shape == (ELEVATION, ELEVATION)
    assert later[LOG_SCALE, LOG_SCALE] > 50 * first[LOG_SCALE, LOG_SCALE]
    assert later[SHIFT_X, SHIFT_X] == first[SHIFT_X, SHIFT_X]
