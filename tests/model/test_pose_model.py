import io
import json

import numpy as np
import pybvh
import pytest

import silpose
from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.descriptor import ShapeContextHistogram
from silpose.model.pose_model import PoseModel
from silpose.regression import RelevanceVectorRegressor, RidgeRegressor


@pytest.fixture(scope="module", params=[RidgeRegressor, RelevanceVectorRegressor])
def model(request, sequence):
    sparse = request.param is RelevanceVectorRegressor
    regressor = request.param(nu=0.1) if sparse else request.param(damping=0.01)
    histogram = ShapeContextHistogram(codebook_size=30)
    return PoseModel(histogram, regressor, ANGLES, 15.0).fit(sequence.masks, sequence.x)


def test_poses_have_joints_and_heading(model, sequence):
    poses = model.predict(sequence.masks)
    assert len(poses) == 40
    assert poses.x.shape == (40, 55)
    assert poses.joints.shape == (40, len(ANGLES.joint_names), 3)
    off = np.abs((poses.heading - ANGLES.heading(sequence.x) + 180) % 360 - 180)
    assert np.median(off) < 10
    assert np.median(poses.heading_norm) == pytest.approx(1, abs=0.2)


def test_poses_are_saved_as_bvh(model, mask_folder, tmp_path):
    poses = model.predict(mask_folder, blank="nan")
    poses.save_bvh(tmp_path / "poses.bvh", 15.0)
    bvh = pybvh.read_bvh_file(tmp_path / "poses.bvh")
    assert bvh.frame_count == 12
    read = bvh.node_positions(centered="skeleton")[:, bvh.node_index["left_knee"]]
    knee = ANGLES.joints(poses.x[:5])[:, ANGLES.joint_names.index("left_knee")]
    np.testing.assert_allclose(read[:5], knee, atol=1e-5)
    np.testing.assert_array_equal(read[5], read[4])  # the sixth is blank


def test_array_list_and_folder_agree(model, mask_folder, sequence):
    from_folder = model.predict(mask_folder, blank="nan")
    np.testing.assert_array_equal(from_folder.x[:5], model.predict(sequence.masks[:5]).x)
    np.testing.assert_array_equal(from_folder.x[:5], model.predict(list(sequence.masks[:5])).x)


def test_a_blank_mask_is_a_row_of_nan_or_an_error_that_names_it(model, mask_folder, sequence):
    poses = model.predict(mask_folder, blank="nan")
    for rows in (poses.x, poses.joints.reshape(12, -1)):
        np.testing.assert_array_equal(np.isnan(rows).all(axis=1), np.arange(12) == 5)
    with pytest.raises(InputError, match=r"5\.png' has no foreground"):
        model.predict(mask_folder)
    with pytest.raises(InputError, match="mask 1 has no foreground"):
        model.predict([sequence.masks[0], 0 * sequence.masks[0]])
    with pytest.raises(InputError, match="blank is 'error' or 'nan'"):
        model.predict(sequence.masks, blank="skip")


def test_saved_and_loaded_it_predicts_the_same(model, sequence, tmp_path):
    model.save(tmp_path / "model.npz")
    for place in (tmp_path / "model.npz", tmp_path):
        loaded = silpose.load(place)
        assert loaded.frames_per_second == 15
        np.testing.assert_array_equal(
            loaded.predict(sequence.masks).x, model.predict(sequence.masks).x
        )


def test_a_file_that_is_no_model_is_named(tmp_path):
    with pytest.raises(InputError, match="there is no model"):
        silpose.load(tmp_path)
    other = io.BytesIO()
    np.savez(other, a=np.ones(3))
    for content in (b"", b"nonsense", other.getvalue()):
        (tmp_path / "model.npz").write_bytes(content)
        with pytest.raises(InputError, match=r"model\.npz' is no silpose model"):
            silpose.load(tmp_path)


def test_another_format_asks_for_training_anew(model, tmp_path):
    model.save(tmp_path / "model.npz")
    arrays = dict(np.load(tmp_path / "model.npz"))
    header = json.loads(str(arrays["header"])) | {"format": 99}
    np.savez(tmp_path / "model.npz", **(arrays | {"header": np.array(json.dumps(header))}))
    with pytest.raises(InputError, match="format 99"):
        silpose.load(tmp_path)
