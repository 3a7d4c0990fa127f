from dataclasses import replace

import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.recording import GroundTruth, record_tracking
from silpose.recording import entity_paths as entities
from silpose.silhouette import Camera
from silpose.tracking import Track


def test_a_state_is_logged_where_it_changes(recordings, logged):
    states = logged(recordings["tracking"], entities.STATE, "StateChange:state")
    assert states == [["starting"], ["tracking"], ["lost"]]
    colours = logged(recordings["tracking"], entities.STATE, "StateConfiguration:values", True)
    assert colours == [["starting", "tracking", "lost", "recovered"]]


def test_beliefs_are_summed_by_heading(recordings, sequence, logged):
    """Frame k believes in key pose k alone, and key poses face all ways around."""
    bars = logged(recordings["tracking"], entities.BELIEF, "BarChart:values")
    shares = np.array([bar[0]["buffer"] for bar in bars])
    assert shares.shape == (len(sequence), 24)
    assert shares.sum(axis=1) == pytest.approx(1)
    facing = np.linspace(-180, 179, len(sequence))
    assert shares.argmax(axis=1).tolist() == ((facing + 180) // 15).astype(int).tolist()


def test_methods_stand_side_by_side_on_the_truth(recordings, logged):
    def middle(entity):
        strips = logged(recordings["tracking"], entity, "LineStrips3D:strips")[0]
        return np.array(strips)[:, 0, 0].reshape(-1, len(ANGLES.bones)).mean(axis=1)

    true = middle(entities.TRUE_SKELETON)
    assert np.diff(true) == pytest.approx([1.0])  # metres
    own = [middle(f"{entities.TRACKS}/{method}/skeleton")[0] for method in ("ridge", "tracker")]
    assert own == pytest.approx(true)


def test_kernels_of_each_tracker_are_bars(recordings, logged):
    bars = logged(recordings["extinction"], f"{entities.KERNELS}/usual", "BarChart:values")
    assert [np.argmax(bar[0]["buffer"]) for bar in bars] == list(range(5))


def test_400_tracked_frames_fit_in_5_MB(sequence, header, tmp_path):
    """With masks of 256 x 256, beliefs and four methods, as the experiment draws them."""
    masks = [
        np.kron(mask, np.ones((3, 3), np.uint8))[16:272, 16:272]
        for mask in (sequence.masks[k % len(sequence)] for k in range(400))
    ]
    rng = np.random.default_rng(0)
    x = np.tile(sequence.x, (10, 1)) + rng.normal(size=(400, 55))
    take = replace(sequence, x=x, masks=np.stack(masks), offset=np.tile(sequence.offset, (10, 1)))
    errors = {f"method {k}": rng.random(400) for k in range(14)}
    truth = GroundTruth.of(take, Camera(), errors, ANGLES)
    methods = ("ridge", "dynamics", "state_sensitive", "tracker")
    tracks = {method: x + rng.normal(size=x.shape) for method in methods}
    track = Track(x, ["tracking"] * 400, rng.dirichlet(np.full(370, 0.1), 400))
    file = tmp_path / "run.rrd"
    record_tracking(header(file), take, truth, tracks, track, rng.uniform(-180, 180, 370), ANGLES)
    assert 2e6 < file.stat().st_size < 5e6


def test_a_track_without_beliefs_is_refused(sequence, states, header, tmp_path):
    truth = GroundTruth.of(sequence, Camera(), {}, ANGLES)
    track = Track(sequence.x, states)
    with pytest.raises(ValueError, match="without beliefs"):
        record_tracking(
            header(tmp_path / "run.rrd"), sequence, truth, {}, track, np.empty(0), ANGLES
        )
    assert not list(tmp_path.iterdir())
