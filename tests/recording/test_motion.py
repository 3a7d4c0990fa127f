import numpy as np

from silpose.core.pose_space import ANGLES
from silpose.recording import entity_paths as entities
from silpose.recording import read_recording


def test_a_take_begins_above_the_origin_and_its_poses_are_read_back(recordings, sequence, logged):
    strips = logged(recordings["motion"], entities.TRUE_SKELETON, "LineStrips3D:strips")
    assert len(strips) == len(sequence)
    first = np.array(strips[0])[0, 0]  # the root
    assert np.allclose(first[[0, 2]], ANGLES.joints(sequence.x[:1])[0, 0, [0, 2]], atol=1e-5)
    poses = read_recording(recordings["motion"]).poses["true"]
    assert np.allclose(poses, sequence.x, atol=1e-4)


def test_the_heading_and_the_figure_are_there(recordings, sequence, logged):
    headings = logged(recordings["motion"], entities.TRUE_HEADING, "Scalars:scalars")
    known = [value for row in headings for value in row]  # a row without one where it wraps
    assert np.allclose(known, ANGLES.heading(sequence.x), atol=1e-3)
    assert logged(recordings["motion"], entities.FIGURE, "EncodedImage:blob", True)
