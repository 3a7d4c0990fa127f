import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.recording import load_poses, read_poses, read_recording, record_prediction


def test_poses_come_back_as_they_were(finished):
    poses = load_poses(finished.folder)
    assert set(poses) == {"true", "estimated"}
    assert poses["true"].shape == poses["estimated"].shape == (45, 55)
    off = finished.model.space.distance(poses["true"], poses["estimated"]).mean()
    assert off == pytest.approx(finished.metrics["rvm_20"]["mean_angular_error_deg"])


def test_a_frame_without_an_estimate_is_nan(tmp_path, finished, mask_folder, header):
    details = finished.model.explain(mask_folder, blank="nan")
    poses = finished.model.predict(details)
    record_prediction(header(tmp_path / "p.rrd"), finished.model, details, poses)
    estimated = read_poses(tmp_path / "p.rrd")["estimated"]
    assert np.isnan(estimated).any(axis=1).tolist() == [frame == 5 for frame in range(12)]
    assert estimated[6] == pytest.approx(details.x[6], rel=1e-6)


def test_errors_and_times_come_back(finished):
    recorded = read_recording(finished.recording)
    assert recorded.columns == finished.model.space.columns
    assert recorded.time == pytest.approx(np.arange(45) / 15)
    assert set(recorded.errors) == set(finished.metrics)
    off = finished.model.space.distance(recorded.poses["true"], recorded.poses["estimated"])
    assert recorded.errors["rvm_20"] == pytest.approx(off, rel=1e-4)


@pytest.fixture
def changed(finished, tmp_path):
    """Write a recording whose bytes are not as they should be."""

    def write(change):
        path = tmp_path / "changed.rrd"
        path.write_bytes(change(finished.recording.read_bytes()))
        return path

    return write


BROKEN = {
    "is no recording": lambda content: b"nonsense",
    "is no recording of this version": lambda content: b"RRF0" + content[4:],
    "written by Rerun 0.20, which Rerun 0.41 cannot read: run the experiment again": (
        lambda content: content[:4] + bytes([0, 20]) + content[6:]
    ),
    "was cut off: 'silpose repair": lambda content: content[: len(content) // 2],
    "cut off": lambda content: content[:8],
}


@pytest.mark.parametrize("said", BROKEN)
def test_what_cannot_be_read_is_one_sentence(changed, said, recwarn):
    path = changed(BROKEN[said])
    with pytest.raises(InputError, match=said) as error:
        read_poses(path)
    assert str(path) in str(error.value)
    assert not recwarn.list  # Rerun's own words would be a second sentence


def test_what_is_not_there_is_named(tmp_path):
    with pytest.raises(InputError, match="no recording"):
        read_poses(tmp_path / "missing.rrd")
