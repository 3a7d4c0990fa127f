import numpy as np
import pytest

from silpose.fitting.geometry import geometry_of
from silpose.fitting.parameters import (
    ANGLES,
    ELEVATION,
    LOG_SCALE,
    PARAMETERS,
    SHAPE,
    SHIFT_X,
    SHIFT_Y,
    difference,
    seen_by,
    shaped_by,
    take_step,
)


def test_angles_alone_change_neither_view_nor_shape(body, view):
    geometry = geometry_of(body)
    assert seen_by(np.ones(ANGLES), view) == view
    np.testing.assert_array_equal(shaped_by(np.ones(ANGLES), geometry).points, geometry.points)


def test_each_parameter_of_the_camera_has_its_place(view):
    parameters = np.zeros(PARAMETERS)
    parameters[[SHIFT_X, SHIFT_Y, LOG_SCALE, ELEVATION]] = 1.0, 2.0, 0.3, 0.4
    seen = seen_by(parameters, view)
    assert (seen.shift_x, seen.shift_y) == (1.0, 2.0)
    assert (seen.log_scale, seen.elevation) == (0.3, view.elevation + 0.4)


def test_the_shape_is_linear_in_its_coefficients(body):
    geometry, parameters = geometry_of(body), np.zeros(PARAMETERS)
    parameters[SHAPE + 1] = 2.0
    shaped = shaped_by(parameters, geometry)
    np.testing.assert_allclose(
        shaped.offsets, geometry.offsets + 2 * geometry.offset_slopes[1], atol=1e-12
    )


def test_angles_are_subtracted_the_short_way_round():
    one, other = np.zeros(PARAMETERS), np.zeros(PARAMETERS)
    one[0], other[0] = np.pi - 0.1, 0.1 - np.pi
    one[SHIFT_X] = 10.0
    off = difference(one, other)
    assert off[0] == pytest.approx(-0.2)
    assert off[SHIFT_X] == 10.0


def test_a_step_is_cut_where_the_linear_model_ends():
    parameters, step = np.zeros(PARAMETERS), np.zeros(PARAMETERS)
    step[[0, SHIFT_Y, SHAPE]] = 3.0, -100.0, 0.1
    assert take_step(parameters, step) == 1.0
    assert 0 < parameters[0] < np.deg2rad(30)
    assert -100 < parameters[SHIFT_Y] < 0
    assert parameters[SHAPE] == pytest.approx(0.1)
    assert take_step(parameters, 0 * step) == 0.0
