import numpy as np
import pandas
import pybvh
import pytest

from silpose.core.skeleton import POINTS
from silpose.model.video import track_files


@pytest.fixture(scope="module")
def written(fitted, tmp_path_factory):
    folder = tmp_path_factory.mktemp("track")
    for name, write in track_files(fitted.track).items():
        write(folder / name)
    return folder


def test_every_frame_has_a_row_in_the_table(written, fitted):
    table = pandas.read_csv(written / "track.csv")
    assert len(table) == len(fitted.track)
    assert list(table["frame"]) == list(range(22))
    assert table["state"].iloc[-1] == "blank" and np.isnan(table["root_x_m"].iloc[-1])
    np.testing.assert_allclose(table["root_x_m"], fitted.track.path[:, 0], rtol=1e-4, atol=1e-5)


def test_arrays_are_those_of_the_track(written, fitted):
    with np.load(written / "track.npz", allow_pickle=False) as arrays:
        assert arrays["angles"].shape == (22, 54) and arrays["covariance"].dtype == np.float32
        np.testing.assert_array_equal(arrays["joints"], fitted.track.joints)
        assert list(arrays["joint_names"]) == list(POINTS)


def test_joints_are_read_from_trc_as_other_programs_do(written, fitted):
    file = written / "track.trc"
    lines = file.read_text().splitlines()
    header = dict(zip(lines[1].split("\t"), lines[2].split("\t"), strict=True))
    assert header["Units"] == "m" and float(header["DataRate"]) == pytest.approx(25, abs=0.1)
    assert (header["NumFrames"], header["NumMarkers"]) == ("22", "23")
    names = [name for name in lines[3].split("\t")[2:] if name]
    table = pandas.read_csv(file, sep="\t", skiprows=4)
    joints = table.iloc[:, 2:].to_numpy(float).reshape(22, 23, 3)
    assert names == list(POINTS)
    np.testing.assert_allclose(joints, fitted.track.joints, atol=1e-6)
    np.testing.assert_allclose(table.iloc[:, 1], fitted.track.poses.time, atol=1e-6)


def test_the_motion_walks_where_the_person_did(written, fitted):
    bvh = pybvh.read_bvh_file(written / "track.bvh")
    root = np.asarray(bvh.root_pos)
    known = fitted.track.poses.known
    np.testing.assert_allclose(root[known], fitted.track.path[known], atol=1e-3)
    assert len(root) == 22  # frames without a pose repeat the one before
