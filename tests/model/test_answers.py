import warnings
from dataclasses import replace

import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.descriptor import ShapeContextHistogram
from silpose.fitting import BodyFitter, Confidence, PosePrior
from silpose.model import PoseFitter, PoseModel
from silpose.regression import RidgeRegressor
from silpose.tracking import STATES, BeliefTracker


class Known:
    """The same confidence in every pose."""

    def __init__(self, value, most=1.0):
        self.value, self.most, self.asked = value, most, []

    def of(self, z, x, facts):
        self.asked.append((z, x, facts))
        return np.where(np.isfinite(x).all(axis=1), self.value, 0.0)

    def highest(self, facts):
        return np.full(len(facts.blank), self.most)


@pytest.fixture(scope="module")
def model(sequence, body, camera):
    """A model that can do everything."""
    histogram = ShapeContextHistogram(codebook_size=30)
    z = histogram.fit_transform(sequence.masks)
    prior = PosePrior(25.0 * np.eye(54), 2e4 * np.eye(54))
    usual = Confidence(usual_iou=0.9)
    fitter = PoseFitter(BodyFitter(body, camera, prior, confidence=usual), z, sequence.x, 2)
    regressor = RidgeRegressor(damping=0.01).fit(z, sequence.x)
    tracker = BeliefTracker(keep=0.5).fit([(z, sequence.x)])
    return PoseModel(histogram, regressor, ANGLES, 15.0, tracker, fitter, Known(0.8))


@pytest.fixture
def masks(sequence):
    """Ten masks, the fifth of them blank."""
    masks = sequence.masks[:10].copy()
    masks[4] = 0
    return masks


def all_answers(model, masks, rate=15.0):
    stream = model.stream(frames_per_second=rate)
    steps = [stream.step(mask) for mask in masks]
    return {
        "predict": model.predict(masks, blank="nan", frames_per_second=rate),
        "fit": model.predict(masks, blank="nan", fit=True, frames_per_second=rate),
        "track": model.track(masks, frames_per_second=rate),
        "stream": type(steps[0]).concatenate(steps),
    }


def test_whatever_gives_poses_gives_the_same_kind_of_answer(model, masks, tmp_path):
    for name, poses in all_answers(model, masks, 30.0).items():
        assert len(poses) == len(poses.state) == len(poses.time) == len(poses.confidence) == 10
        np.testing.assert_allclose(poses.time, np.arange(10) / 30, atol=1e-9)
        assert poses.frames_per_second == pytest.approx(30)
        assert ((poses.confidence >= 0) & (poses.confidence <= 1)).all()
        assert poses.facts.blank.nonzero()[0].tolist() == [4]
        assert poses.joints.shape == (10, len(ANGLES.joint_names), 3)
        poses.save_bvh(tmp_path / f"{name}.bvh")
        assert poses.summary().startswith("10 masks, 1 blank, 0 doubtful")


def test_states_say_what_became_of_each_frame(model, masks):
    states = {name: set(poses.state) for name, poses in all_answers(model, masks).items()}
    assert states["predict"] == {"estimated", "blank"}
    assert states["fit"] <= {"fitted", "poor", "blank"}
    assert states["track"] <= {*STATES} and states["stream"] <= {*STATES}


def test_confidence_knows_what_was_seen(model, masks):
    known = Known(0.7)
    poses = replace(model, confidence=known).predict(masks, blank="nan")
    z, x, facts = known.asked[-1]
    assert np.isnan(z).all(axis=1).nonzero()[0].tolist() == [4]
    np.testing.assert_array_equal(x, poses.x)
    assert len(facts) == 10
    assert poses.confidence[4] == 0 and not poses.doubtful.any()


def test_confidence_in_fits_is_their_own(model, masks):
    known = Known(0.2)
    fitted = replace(model, confidence=known).predict(masks, blank="nan", fit=True)
    assert not known.asked
    assert fitted.confidence[4] == 0 and not fitted.doubtful.any()


def test_many_doubtful_poses_are_a_warning_that_names_the_source(model, masks, mask_folder):
    own = replace(model, confidence=Known(0.2))
    with pytest.warns(UserWarning, match=r"11 of 12 frames of '.*' look like nothing that trained"):
        poses = own.predict(mask_folder, blank="nan")
    assert poses.doubtful.sum() == 11  # the blank one has no pose
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        model.predict(mask_folder, blank="nan")


def test_a_model_without_calibration_says_so(model, masks):
    own = replace(model, confidence=None)
    with pytest.warns(UserWarning, match="without a calibration"):
        poses = own.predict(masks, blank="nan")
    assert np.isnan(poses.confidence).all() and not poses.doubtful.any()
    assert "confidence unknown" in poses.summary()
    with pytest.warns(UserWarning, match="without a calibration"):
        own.stream()


def test_times_may_be_uneven(model, masks):
    time = np.array([0, 1, 2, 3, 5, 6, 7, 8, 9, 12]) / 15
    poses = model.track(masks, time=time)
    np.testing.assert_array_equal(poses.time, time)
    assert np.isfinite(poses.x).all()
    assert len(poses.track.x) == 13
    with pytest.raises(InputError, match="not after"):
        model.track(masks, time=time[::-1])


def test_details_may_be_given_instead_of_masks(model, masks):
    details = model.explain(masks, blank="nan", frames_per_second=30)
    np.testing.assert_array_equal(model.predict(details).x, details.x)
    assert model.predict(details).frames_per_second == pytest.approx(30)
    assert model.track(details, frames_per_second=15).frames_per_second == pytest.approx(15)


def test_an_option_that_there_is_not_is_named(model, masks):
    with pytest.raises(InputError, match=r"no option 'persn': give one of blank, .*person"):
        model.predict(masks, persn="left")


def test_blank_frames_are_counted_as_blank_and_not_as_doubtful(model, masks):
    own = replace(model, confidence=Known(0.2))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        poses = own.track(masks[[0] + [4] * 12], frames_per_second=15)
    assert poses.doubtful.all()
    assert poses.summary().startswith("13 masks, 12 blank, 1 doubtful")


def test_masks_that_are_missing_by_their_names_are_gaps_in_time(model, sequence, tmp_path):
    kept = [0, 1, 2, 3, 7, 8, 9, 15]
    for k in kept:
        cv2.imwrite(str(tmp_path / f"frame_{k:04d}.png"), 255 * sequence.masks[k])
    model = replace(model, confidence=Known(0.8))
    said = rf"8 masks in '{tmp_path}' are missing .* first after 'frame_0003\.png'.* time: .* anew"
    with pytest.warns(UserWarning, match=said + "$"):
        tracked = model.track(tmp_path, frames_per_second=30)
    by_time = model.track(sequence.masks[kept], time=np.array(kept) / 30)
    np.testing.assert_allclose(tracked.time, np.array(kept) / 30)
    np.testing.assert_allclose(tracked.x, by_time.x)
    with pytest.warns(UserWarning, match=said + "$"):
        np.testing.assert_allclose(model.predict(tmp_path, frames_per_second=10).time[-1], 1.5)
    with pytest.warns(UserWarning, match=said + "; a fit takes"):
        model.predict(tmp_path, fit=True)
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # without a rate, no time was asked for
        np.testing.assert_allclose(model.predict(tmp_path).time, np.array(kept) / 15)
        model.track(tmp_path, time=np.arange(8))


def test_a_rate_is_asked_for_before_masks_are_described(model, mask_folder, monkeypatch):
    monkeypatch.delattr(PoseModel, "explain")
    with pytest.raises(InputError, match=r"frame rate of .* is not known"):
        model.track(mask_folder)


def test_a_fit_is_no_surer_than_its_masks_allow(model, masks):
    own = replace(model, confidence=Known(0.8, most=0.2))
    assert own.predict(masks, blank="nan", fit=True).confidence.max() == 0.2
    stream = own.stream(fit=True)
    assert max(stream.step(mask).confidence[0] for mask in masks[:3]) == 0.2
