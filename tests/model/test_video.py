"""From a film to fitted poses, and live."""

import numpy as np
import pytest
from video_films import figure, noisy, paint, wall, write_film

from silpose.core.pose_space import ANGLES
from silpose.descriptor import ShapeContextHistogram
from silpose.fitting import BodyFitter, Confidence, PosePrior
from silpose.model import PoseFitter, PoseModel
from silpose.regression import RidgeRegressor
from silpose.silhouette.video import VideoMasks


@pytest.fixture(scope="module")
def model(sequence, body, camera):
    histogram = ShapeContextHistogram(codebook_size=30)
    z = histogram.fit_transform(sequence.masks)
    prior = PosePrior(25.0 * np.eye(54), 2e4 * np.eye(54))
    usual = Confidence(usual_iou=0.9)
    fitter = PoseFitter(BodyFitter(body, camera, prior, confidence=usual), z, sequence.x, 2)
    regressor = RidgeRegressor(damping=10).fit(z, sequence.x)
    return PoseModel(histogram, regressor, ANGLES, 15.0, None, fitter)


@pytest.fixture(scope="module")
def film(tmp_path_factory, sequence):
    rng = np.random.default_rng(1)
    empty = noisy(wall(), rng)
    people = [noisy(paint(wall(), figure(sequence.masks, k)), rng) for k in range(32)]
    pictures = [empty, empty, *people, empty]
    return write_film(tmp_path_factory.mktemp("film") / "walk.mp4", pictures, rate=15)


def test_a_film_becomes_fitted_poses(model, film):
    poses = model.predict(VideoMasks(film, last=5).masks(), blank="nan", fit=True)
    assert len(poses) == 6
    assert poses.state[0] == "blank"
    assert np.isfinite(poses.x[2:]).all()
    assert poses.frames_per_second == pytest.approx(15)


def test_a_film_is_fitted_frame_by_frame(model, film):
    stream = model.stream(fit=True)
    seen = [stream.step(frame.mask, frame.time).known[0] for frame in VideoMasks(film, last=6)]
    assert seen == [False] * 2 + [True] * 5
