import numpy as np
import pytest

from silpose import load_poses
from silpose.errors import InputError
from silpose.recording import read_poses
from silpose.run import runs_table


def test_poses_come_back_as_they_were(finished):
    poses = load_poses(finished.folder)
    assert set(poses) == {"true", "estimated"}
    assert poses["true"].shape == poses["estimated"].shape == (45, 55)
    off = finished.model.space.distance(poses["true"], poses["estimated"]).mean()
    assert off == pytest.approx(finished.metrics["rvm_20"]["mean_angular_error_deg"])


def test_a_frame_without_an_answer_is_nan(tmp_path, finished, mask_folder):
    from silpose.recording import record_prediction, texts

    look = finished.model.look(mask_folder, blank="nan")
    words = texts("masks", "", {})
    record_prediction(tmp_path / "p.rrd", "p", finished.model, look, 15.0, words)
    estimated = read_poses(tmp_path / "p.rrd")["estimated"]
    assert np.isnan(estimated).any(axis=1).tolist() == [frame == 5 for frame in range(12)]
    assert estimated[6] == pytest.approx(look.x[6])


def test_what_is_no_recording_is_named(tmp_path, finished):
    with pytest.raises(InputError, match="no recording"):
        read_poses(tmp_path / "missing.rrd")
    broken = tmp_path / "broken.rrd"
    broken.write_bytes(b"nonsense")
    with pytest.raises(InputError, match=r"broken\.rrd"):
        read_poses(broken)


def test_runs_make_a_table(finished, tmp_path):
    (tmp_path / "tracking" / "cut_off").mkdir(parents=True)
    table = runs_table(finished.folder.parents[1])
    row = table.loc[("single_image", "small")]
    assert row["complete"]
    assert row["ridge.mpjpe_mm"] == finished.metrics["ridge"]["mpjpe_mm"]
    assert not runs_table(tmp_path).loc[("tracking", "cut_off"), "complete"]
    with pytest.raises(InputError, match="no folder"):
        runs_table(tmp_path / "nowhere")
