import numpy as np
from synthetic import motion


def test_a_part_has_the_frames_between():
    whole = motion("walk", 10)
    part = whole.part(2, 5)
    assert (len(part), part.name, part.performer) == (3, "walk", "someone")
    np.testing.assert_array_equal(part.angles, whole.angles[2:5])
    np.testing.assert_array_equal(part.root_position, whole.root_position[2:5])
    assert len(whole) == 10
