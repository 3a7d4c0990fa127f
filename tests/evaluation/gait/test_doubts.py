import numpy as np
import pytest


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({}, ""),
        ({"scale": 1.3}, ""),
        ({"camera_azimuth": 180.0}, "180 degrees off"),
        ({"camera_azimuth": 90.0}, "degrees off"),
        ({"path": 0.0}, "treadmill"),
        ({"path": 4.0}, "in metres"),
        ({"path": "z up"}, "is +Y up"),
    ],
)
def test_a_path_that_the_feet_did_not_walk_is_noted(straight, report_of, options, words):
    path = straight.root_position[::4]
    given = options.get("path", 1.0)
    path = path[:, [0, 2, 1]] if given == "z up" else given * path
    notes = report_of(straight, 4, **{**options, "path": path}).notes
    assert any(words in note for note in notes) if words else notes == ()


def test_without_a_stretch_there_is_no_doubt(straight, report_of):
    part = straight.part(0, 40)
    assert report_of(part, 4, path=np.zeros((10, 3))).notes == ()
