from dataclasses import replace

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.descriptor import ShapeContextHistogram
from silpose.fitting import BodyFitter, Confidence, FittingOptions, PosePrior
from silpose.model import PoseFitter, PoseModel, Poses, load
from silpose.regression import RidgeRegressor
from silpose.silhouette import Body, render
from silpose.tracking import BeliefTracker


@pytest.fixture(scope="module")
def model(sequence, body, camera):
    """A model of the sequence, whose fitter expects errors of a few degrees."""
    histogram = ShapeContextHistogram(codebook_size=30)
    z = histogram.fit_transform(sequence.masks)
    prior = PosePrior(25.0 * np.eye(54), 2e4 * np.eye(54))
    usual = Confidence(usual_iou=0.9)
    fitter = PoseFitter(BodyFitter(body, camera, prior, confidence=usual), z, sequence.x, 2)
    regressor = RidgeRegressor(damping=10).fit(z, sequence.x)
    return PoseModel(histogram, regressor, ANGLES, 15.0, None, fitter)


@pytest.fixture(scope="module")
def tracking(model, sequence):
    tracker = BeliefTracker(keep=0.5).fit([(model.fitter.z, sequence.x)])
    return replace(model, tracker=tracker)


def overlaps(x, masks, body, camera):
    """Overlap of masks and the silhouettes of poses."""
    filled = np.stack(list(render(body, camera, ANGLES.rotations(x))))
    return (filled & masks).sum(axis=(1, 2)) / (filled | masks).sum(axis=(1, 2))


@pytest.mark.parametrize("kind", ["model", "tracking"])
def test_fitted_poses_explain_the_masks(kind, sequence, body, camera, request):
    own, masks = request.getfixturevalue(kind), sequence.masks[:10]
    poses, plain = own.predict(masks, fit=True), own.predict(masks)
    np.testing.assert_allclose(poses.iou, overlaps(poses.x, masks, body, camera), atol=0.02)
    assert poses.iou.mean() > overlaps(plain.x, masks, body, camera).mean() + 0.05
    assert set(poses.state) == {"fitted"} and poses.confidence.min() >= 0.5
    assert plain.iou is None and set(plain.state) == {"estimated"}


def test_a_single_mask_is_fitted(model, sequence):
    poses = model.predict(sequence.masks[3:4], fit=True)
    assert np.isfinite(poses.x).all() and poses.iou[0] > 0.8


def test_a_blank_mask_has_a_state(model, mask_folder):
    poses = model.predict(mask_folder, blank="nan", fit=True)
    assert [state == "blank" for state in poses.state] == [frame == 5 for frame in range(12)]
    np.testing.assert_array_equal(np.isnan(poses.iou), np.arange(12) == 5)


def test_live_it_fits_frame_by_frame(model, tracking, sequence):
    masks = sequence.masks[:10].copy()
    masks[4] = 0
    for own in (model, tracking):
        stream = own.stream(fit=True)
        live = Poses.concatenate([stream.step(mask) for mask in masks])
        assert live.state[4:6] == ["lost", "recovered"]
        assert np.isnan(live.iou).nonzero()[0].tolist() == [4]
        seen = np.arange(10) != 4
        assert ANGLES.distance(sequence.x[:10], live.x)[seen].mean() < 4


def test_fitted_poses_may_start_a_tracker(tracking, sequence):
    fitted = tracking.predict(sequence.masks[:2], fit=True).x
    z = tracking.descriptor.transform(sequence.masks[:6])
    track = tracking.tracker.track(z, initial=fitted)
    np.testing.assert_array_equal(track.x[:2], fitted)
    assert np.isfinite(track.x).all()


@pytest.mark.parametrize("shape", [None, [0.5] * 10])
def test_saved_and_loaded_it_fits_the_same(model, sequence, shape, tmp_path):
    own = model.fitter
    fitter = BodyFitter(Body(level=2, shape=shape), own.fitter.camera, own.fitter.prior)
    model = replace(model, fitter=replace(own, fitter=fitter))
    model.save(tmp_path / "model.npz")
    poses, again = (m.predict(sequence.masks[:4], fit=True) for m in (model, load(tmp_path)))
    np.testing.assert_array_equal(poses.x, again.x)
    np.testing.assert_array_equal(poses.iou, again.iou)
    np.testing.assert_array_equal(poses.confidence, again.confidence)


def test_options_of_a_run_replace_those_of_training(model):
    options = FittingOptions(camera="estimated", iterations=3, starts=1, lasting=0.1, seconds=1.0)
    changed = model.fitter.with_options(options)
    assert (changed.fitter.camera_is, changed.fitter.iterations, changed.starts) == (
        "estimated", 3, 1,
    )  # fmt: skip
    assert (changed.fitter.prior.lasting, changed.fitter.prior.seconds) == (0.1, 1.0)
    np.testing.assert_array_equal(
        changed.fitter.prior.covariance, model.fitter.fitter.prior.covariance
    )


def test_masks_of_another_size_are_seen_by_a_camera_that_differs_in_nothing_else(
    model, sequence, body, camera
):
    large = replace(camera, width=144, height=144)
    masks = list(render(body, large, ANGLES.rotations(sequence.x[:4])))
    poses = model.predict(masks, fit=True)
    assert poses.iou.min() > 0.85
    stream = model.stream(fit=True)
    assert [stream.step(mask).state[0] for mask in masks][-1] in ("tracking", "recovered")
    with pytest.raises(InputError, match=r"sizes \(96, 96\) and \(144, 144\)"):
        model.predict([sequence.masks[0], masks[1]], fit=True)


def test_a_model_without_fitter_says_how_to_train_one(model, sequence):
    without = replace(model, fitter=None)
    with pytest.raises(InputError, match=r"fitting\.enabled=true"):
        without.predict(sequence.masks, fit=True)
    with pytest.raises(InputError, match=r"fitting\.enabled=true"):
        without.stream(fit=True)
