import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.descriptor import ShapeContextHistogram
from silpose.model import PoseModel, Poses
from silpose.regression import RelevanceVectorRegressor, RidgeRegressor
from silpose.tracking import BeliefTracker


@pytest.fixture(scope="module", params=[RidgeRegressor, RelevanceVectorRegressor])
def model(request, sequence):
    sparse = request.param is RelevanceVectorRegressor
    regressor = request.param(nu=0.1) if sparse else request.param(damping=0.01)
    histogram = ShapeContextHistogram(codebook_size=30)
    return PoseModel(histogram, regressor, ANGLES, 15.0).fit(sequence.masks, sequence.x)


@pytest.fixture(scope="module")
def tracking(sequence):
    """A model that tracks."""
    histogram = ShapeContextHistogram(codebook_size=30)
    z = histogram.fit_transform(sequence.masks)
    tracker = BeliefTracker(keep=0.5).fit([(z, sequence.x)])
    regressor = RidgeRegressor(damping=0.01).fit(z, sequence.x)
    return PoseModel(histogram, regressor, ANGLES, 15.0, tracker)


def test_poses_have_joints_and_heading(model, sequence):
    poses = model.predict(sequence.masks)
    assert len(poses) == 40
    assert poses.x.shape == (40, 55)
    assert poses.joints.shape == (40, len(ANGLES.joint_names), 3)
    off = np.abs((poses.heading - ANGLES.heading(sequence.x) + 180) % 360 - 180)
    assert np.median(off) < 10
    assert np.median(poses.heading_norm) == pytest.approx(1, abs=0.2)


def test_array_list_and_folder_agree(model, mask_folder, sequence):
    from_folder = model.predict(mask_folder, blank="nan")
    masks = sequence.masks[:12].copy()
    masks[5] = 0  # as in the folder; with as many rows, sums are rounded alike
    np.testing.assert_array_equal(from_folder.x, model.predict(masks, blank="nan").x)
    np.testing.assert_array_equal(from_folder.x, model.predict(list(masks), blank="nan").x)


def test_a_blank_mask_is_a_row_of_nan_or_an_error_that_names_it(model, mask_folder, sequence):
    poses = model.predict(mask_folder, blank="nan")
    for rows in (poses.x, poses.joints.reshape(12, -1)):
        np.testing.assert_array_equal(np.isnan(rows).all(axis=1), np.arange(12) == 5)
    with pytest.raises(InputError, match=r"5\.png' has no foreground"):
        model.predict(mask_folder)
    with pytest.raises(InputError, match="mask 'frame 1' has no foreground"):
        model.predict([sequence.masks[0], 0 * sequence.masks[0]])
    with pytest.raises(InputError, match="blank must be 'error' or 'nan'"):
        model.predict(sequence.masks, blank="skip")
    with pytest.raises(InputError, match="none of the 2 masks has a foreground"):
        model.predict(0 * sequence.masks[:2], blank="nan")


def test_every_step_of_a_prediction_is_explained(model, mask_folder):
    details = model.explain(mask_folder, blank="nan")
    assert len(details.masks) == len(details.points) == len(details.nearest) == 12
    assert len(details.points[5]) == len(details.nearest[5]) == 0
    blank = np.arange(12) == 5
    for rows in (details.z, details.activations, details.x):
        np.testing.assert_array_equal(np.isnan(rows).all(axis=1), blank)
    seen = details.z[~blank]
    np.testing.assert_array_equal(details.x[~blank], model.regressor.predict(seen))
    np.testing.assert_array_equal(details.activations[~blank], model.regressor.activations(seen))
    assert max(map(np.max, details.nearest[:5])) < 30


def test_descriptors_are_explained_without_masks(model, sequence):
    z = model.descriptor.transform(sequence.masks[:4])
    details = model.explain_descriptors(z)
    assert details.masks == []
    np.testing.assert_array_equal(details.x, model.predict(sequence.masks[:4]).x)


def test_a_stream_tracks_frame_by_frame_and_changes_no_other(tracking, sequence, tmp_path):
    masks = sequence.masks[:12].copy()
    masks[5] = 0
    track = tracking.track(masks, frames_per_second=15)
    stream, other = tracking.stream(), tracking.stream()
    steps = []
    for mask in masks:
        steps.append(stream.step(mask))
        tracking.track(masks[:3], frames_per_second=15)
        other.step(masks[0])
    live = Poses.concatenate(steps)
    np.testing.assert_allclose(live.x, track.x)
    assert live.state == track.state
    np.testing.assert_allclose(live.time, track.time, atol=1e-9)
    assert live.facts.blank.nonzero()[0].tolist() == [5]
    live.save_bvh(tmp_path / "live.bvh")


def test_a_stream_may_begin_with_a_blank_mask(tracking, sequence):
    stream = tracking.stream()
    assert stream.step(0 * sequence.masks[0]).state == ["starting"]
    assert np.isfinite(stream.step(sequence.masks[1]).x).all()


def test_a_rate_that_is_not_known_is_asked_for(tracking, sequence):
    with pytest.raises(InputError, match=r"silhouette\.frames_per_second=15 \(in Python"):
        tracking.track(sequence.masks)


def test_a_model_without_tracker_says_how_to_train_one(model, sequence):
    for use in (model.stream, lambda: model.track(sequence.masks)):
        with pytest.raises(InputError, match="train one with experiment=tracking"):
            use()
