from dataclasses import replace

import numpy as np
import pytest
from synthetic import motion

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.core.stages import timing
from silpose.dataset import Dataset, render_take
from silpose.descriptor import ShapeContextHistogram
from silpose.fitting import FittingOptions
from silpose.model import FitterTraining, describe_dataset
from silpose.regression import RidgeRegressor
from silpose.silhouette import Body, Camera


@pytest.fixture(scope="module")
def described(body, camera):
    takes = [render_take(motion(f"take{k}", 40, seed=k), body, camera) for k in range(4)]
    data = Dataset("small", ANGLES, takes[:3], [], takes[3:])
    return describe_dataset(data, ShapeContextHistogram(codebook_size=30))


@pytest.fixture(scope="module")
def ridge(described):
    return RidgeRegressor(damping=0.1).fit(*described.joined("train"))


@pytest.fixture(scope="module")
def training(described, ridge, body, camera):
    options = FittingOptions(enabled=True, lasting=0.2, seconds=0.3, starts=2, iterations=5)
    return FitterTraining.of(described, ridge, options, body, camera)


def test_the_prior_is_from_takes_that_are_left_out(training, described, ridge):
    with timing() as seconds:
        left_out = training.left_out
    for k, (z, x) in enumerate(described.train):
        others = [take for j, take in enumerate(described.train) if j != k]
        joined = map(np.concatenate, zip(*others, strict=True))
        alone = RidgeRegressor(damping=0.1).fit(*joined)
        np.testing.assert_allclose(left_out[k], alone.predict(z))
        seen = ANGLES.distance(x, ridge.predict(z)).mean()
        assert ANGLES.distance(x, left_out[k]).mean() > seen
    assert "fitting" in seconds
    assert (training.prior.lasting, training.prior.seconds) == (0.2, 0.3)


def test_performers_are_left_out_whole_where_they_are_kept_apart(described, ridge, body, camera):
    data = described.data
    train = [replace(take, performer=p) for take, p in zip(data.train, "aab", strict=True)]
    test = [replace(take, performer="c") for take in data.test]
    apart = replace(described, data=Dataset("apart", ANGLES, train, [], test, by_performer=True))
    left_out = FitterTraining.of(apart, ridge, FittingOptions(), body, camera).left_out
    (z, _), (_, _), b = described.train
    np.testing.assert_allclose(left_out[0], RidgeRegressor(damping=0.1).fit(*b).predict(z))


def test_starts_are_the_estimate_and_different_training_poses(training, described, ridge):
    z = described.test[0][0][:6].copy()
    z[3] = np.nan
    mean, others = training.starts(z)
    assert others.shape == (6, 2, 55)
    assert list(np.flatnonzero(np.isnan(mean[:, 0]))) == [3]
    assert np.isnan(others[3]).all()
    np.testing.assert_allclose(mean[:3], ridge.predict(z[:3]))
    assert (ANGLES.distance(others[:3, 0], others[:3, 1]) >= 2.5).all()


def test_the_fitter_has_the_options_unless_told_otherwise(training, camera):
    fitter = training.fitter()
    assert (fitter.camera, fitter.iterations, fitter.camera_is) == (camera, 5, "known")
    other = training.fitter(camera=Camera(width=64, height=64), camera_is="estimated")
    assert (other.camera.width, other.camera_is, other.iterations) == (64, "estimated", 5)
    assert other.prior is fitter.prior


def test_the_usual_overlap_is_that_of_fits(training):
    assert 0.8 < training.usual_iou <= 1


def test_of_a_skinned_body_the_rigid_one_is_fitted(described, ridge, camera):
    shape = [0.5] * 10
    body = Body("wooden", shape=shape)
    training = FitterTraining.of(described, ridge, FittingOptions(), body, camera)
    assert training.body.kind == "convex" and list(training.body.shape) == shape


def test_data_without_masks_are_refused(described, ridge, body, camera):
    data = described.data
    bare = [replace(take, masks=None, z=np.zeros((40, 30))) for take in data.train]
    without = replace(described, data=Dataset("bare", ANGLES, bare, [], data.test))
    with pytest.raises(InputError, match="dataset=same_performer"):
        FitterTraining.of(without, ridge, FittingOptions(), body, camera)


def test_what_a_model_keeps_is_saved_and_restored(training, described):
    fitter = training.pose_fitter
    again = type(fitter).from_arrays(
        {name: np.asarray(value) for name, value in fitter.to_arrays().items()}
    )
    take, (z, x) = described.data.test[0], described.test[0]
    masks = list(take.mask_array()[:4])
    one, two = (f.fit(masks, z[:4], x[:4]) for f in (fitter, again))
    np.testing.assert_array_equal(one.x, two.x)
    assert again.usual_iou == fitter.usual_iou
    assert vars(again.fitter.body) == vars(fitter.fitter.body)
