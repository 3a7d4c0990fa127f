import numpy as np
import pytest

from silpose.recording import entity_paths as entities
from silpose.recording import read_poses


def test_modes_are_read_back_by_their_names(recordings, modes):
    poses = read_poses(recordings["hypotheses"])
    names = {"true", "hypotheses", *(f"{n}_{k}" for n in ("mode", "hypothesis") for k in (1, 2))}
    assert set(poses) == names
    assert poses["mode_2"] == pytest.approx(modes[1][:, 1], rel=1e-6)


def test_only_modes_of_some_weight_are_drawn(recordings, modes, logged):
    weights = modes[0][:, 1]
    skeletons = logged(recordings["modes"], f"{entities.MODES}/2/skeleton", "LineStrips3D:strips")
    assert [len(strips) > 0 for strips in skeletons] == (weights > 0).tolist()
    headings = logged(recordings["modes"], f"{entities.MODES}/2/heading", "Scalars:scalars")
    assert np.isnan(np.ravel(headings)).tolist() == (weights == 0).tolist()


def test_the_more_probable_mode_is_thicker_and_more_colourful(recordings, logged):
    thickness, colours = (
        [
            logged(recordings["modes"], f"{entities.MODES}/{k}/skeleton", f"LineStrips3D:{what}")[1]
            for k in (1, 2)
        ]
        for what in ("radii", "colors")
    )
    assert thickness[0][0] > thickness[1][0]
    first, second = (np.array(b, np.uint32)[:, None].view(np.uint8)[:, 1:] for b in colours)
    assert np.ptp(first, axis=1).max() > np.ptp(second, axis=1).max()
