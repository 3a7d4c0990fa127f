import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.evaluation.gait import Walk, azimuth_of_camera, gait_report
from silpose.silhouette import Camera


def test_azimuths():
    places = np.zeros((1, 3))
    for position, azimuth in (((0, 1, 5), 0.0), ((5, 1, 0), 90.0), ((-5, 1, 0), -90.0)):
        assert azimuth_of_camera(places, position) == pytest.approx([azimuth])


@pytest.mark.parametrize("azimuth", [0.0, 130.0])
def test_what_a_camera_at_rest_sees_is_the_walk(straight, straight_report, azimuth):
    camera = Camera(follow=False, distance=8.0, azimuth=azimuth)
    offset, heading = camera.place(straight.root_position[::4], straight.angles[::4, 0])
    x = ANGLES.from_angles(np.column_stack([heading, straight.angles[::4, 1:]]))
    report = gait_report(
        Walk.from_poses(
            x,
            frames_per_second=30.0,
            path=offset,
            camera_azimuth=azimuth_of_camera(offset, camera.position),
        )
    )
    assert len(report.parameters) == len(straight_report.parameters)
    for found, expected in zip(report.parameters, straight_report.parameters, strict=True):
        assert found.value == pytest.approx(expected.value, rel=0.01, abs=0.3), found.name
