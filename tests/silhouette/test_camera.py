import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette import Camera


def test_the_target_is_in_the_middle_and_x_to_the_right():
    camera = Camera(elevation=20, width=200, height=100)
    middle, right, above = camera.project(np.array([[0.0, 0, 0], [0.5, 0, 0], [0, 0.5, 0]]))
    np.testing.assert_allclose(middle, [99.5, 49.5])
    assert right[0] > middle[0] and right[1] == pytest.approx(middle[1])
    assert above[1] < middle[1] and above[0] == pytest.approx(middle[0])


def test_size_in_the_image_follows_from_focal_length_and_distance():
    camera = Camera(elevation=0, focal_length=1.5, distance=3.0, height=100)
    low, high = camera.project(np.array([[0.0, -1, 0], [0, 1, 0]]))
    assert low[1] - high[1] == pytest.approx(1.5 * 100 * 2 / 3)


def test_points_behind_the_camera_are_not_a_number():
    assert np.isnan(Camera().project(np.array([[0.0, 0, 10]]))).all()


def test_the_position_has_the_elevation_and_distance():
    position = Camera(elevation=30, distance=4).position
    np.testing.assert_allclose(position, [0, 2, 4 * np.cos(np.pi / 6)])


def test_following_camera_keeps_the_root_on_the_optical_axis():
    walked = np.array([[0.0, 1, 0], [3, 1, 2]])
    offset, heading = Camera().place(walked, [10.0, 200.0])
    np.testing.assert_allclose(offset, 0)
    np.testing.assert_allclose(heading, [10, -160])


def test_standing_camera_sees_the_heading_from_where_it_is():
    camera = Camera(follow=False, elevation=0, distance=4)
    offset, heading = camera.place([[-4.0, 1, 0], [4.0, 1, 0]], [0.0, 0.0])
    np.testing.assert_allclose(offset[:, 0], [-4, 4])
    np.testing.assert_allclose(heading, [-45, 45])  # the camera is to the left, then the right


def test_an_azimuth_turns_headings_and_an_orbit_lets_them_grow():
    walked = np.zeros((3, 3))
    _, heading = Camera(azimuth=30, orbit=10).place(walked, [0.0, 0.0, 0.0], [0.0, 1.0, 2.0])
    np.testing.assert_allclose(heading, [-30, -40, -50])


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"distance": -1}, "distance must be positive"),
        ({"width": 0}, "width must be positive"),
        ({"elevation": 90}, "elevation must be from -80 to 80"),
    ],
)
def test_wrong_settings_are_named(settings, message):
    with pytest.raises(InputError, match=message):
        Camera(**settings)
