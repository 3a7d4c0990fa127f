import numpy as np

from silpose.core.pose_space import ANGLES
from silpose.evaluation import right_poses


def test_right_is_within_45_degrees_and_120_mm(sequence):
    angles = ANGLES.angles(sequence.x)
    angles[:, 0] += np.linspace(0, 80, 40)
    right = right_poses(ANGLES, sequence.x, ANGLES.from_angles(angles))
    assert right[0] and not right[-1]
    assert right[:10].all() and not right[23:].any()
    bent = sequence.x.copy()
    bent[:, 2:] += 60
    assert not right_poses(ANGLES, sequence.x, bent).any()
