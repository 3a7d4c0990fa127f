import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.recording import GroundTruth, read_poses, record_hypotheses
from silpose.recording import entity_paths as entities
from silpose.silhouette import Camera
from silpose.tracking import Track


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


def test_no_line_goes_on_through_blank_masks_or_over_a_cut(
    sequence, modes, header, logged, tmp_path
):
    weights, means = modes
    weights = weights.copy()
    weights[2] = 0  # a blank mask
    track = Track(sequence.x, ["tracking"] * len(sequence), weights=modes[0], means=means)
    truth = GroundTruth.of(sequence, Camera(), {"hypotheses": np.zeros(len(sequence))}, ANGLES)
    path = tmp_path / "run.rrd"
    record_hypotheses(header(path), sequence, truth, (weights, means), track, ANGLES, cuts=[4])
    alone = logged(path, f"{entities.MODES}/1/weight", "Scalars:scalars")
    assert np.isnan(alone[2]).all() and np.isfinite(alone[1]).all()
    for entity in (
        entities.TRUE_HEADING,
        f"{entities.MODES}/1/weight",
        f"{entities.MODES}/1/heading",
        f"{entities.HYPOTHESES}/1/weight",
        f"{entities.TRACKS}/hypotheses/heading",
    ):
        values = logged(path, entity, "Scalars:scalars")
        frames = logged(path, entity, "frame")
        assert [] in [v for v, f in zip(values, frames, strict=True) if f == 4]
