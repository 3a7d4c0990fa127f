import numpy as np

from silpose.core.pose_space import ANGLES
from silpose.recording import entity_paths as entities
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.layout import study_layout
from silpose.recording.overlay import log_overlay
from silpose.recording.stream import recording_stream


def test_a_skeleton_has_the_height_of_the_mask_and_none_is_drawn_without_a_pose(
    sequence, header, logged, tmp_path
):
    path, x, masks = tmp_path / "run.rrd", sequence.x[:3].copy(), sequence.masks[:3]
    x[1] = np.nan
    with recording_stream(header(path), study_layout(None, 15.0)) as recording:
        log_overlay(FrameLogger(recording, 3, 15.0), x, masks, ANGLES)
    first, none, _ = map(np.array, logged(path, entities.OVERLAID_SKELETON, "Points2D:positions"))
    rows = np.flatnonzero(masks[0].any(axis=1))
    assert np.isnan(none).all()
    assert rows[0] <= first[:, 1].min() < first[:, 1].max() <= rows[-1] + 1
    assert np.ptp(first[:, 1]) > 0.9 * len(rows)
