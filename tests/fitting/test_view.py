import numpy as np

from silpose.fitting.view import projected

PLACES = np.array([[0.0, 0.0, 0.0], [0.4, 0.7, -0.3], [-0.5, -0.9, 0.2]])


def test_places_are_projected_as_by_the_camera(camera, view):
    np.testing.assert_allclose(projected(PLACES, view), camera.project(PLACES), atol=1e-3)


def test_the_image_is_scaled_about_its_centre_and_then_moved(view):
    plain = projected(PLACES, view)
    centre = np.array([view.centre_x, view.centre_y])
    moved = projected(PLACES, view._replace(shift_x=3.0, shift_y=-2.0, log_scale=np.log(2.0)))
    np.testing.assert_allclose(moved, centre + 2 * (plain - centre) + [3.0, -2.0])
