from dataclasses import replace

import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.dataset import Dataset
from silpose.evaluation import right_poses
from silpose.model import DescribedDataset, load
from silpose.model.confidence import train_confidence
from silpose.model.confidence.odd_frames import frames_of_masks


def test_wrong_poses_of_odd_masks_are_mostly_doubtful(small):
    data, descriptor = small.described.data, small.described.descriptor
    frames = frames_of_masks(data.test, descriptor, 0, 300, np.random.default_rng(5))
    estimated = small.regressor.predict(frames.z)
    known = np.isfinite(frames.x).all(axis=1)
    right = np.zeros(len(known), bool)
    right[known] = right_poses(ANGLES, frames.x[known], estimated[known])
    confident = small.confidence.of(frames.z, estimated, frames.facts) >= 0.5
    assert (confident & ~right).sum() < 0.25 * (~right).sum()
    assert right[confident].mean() > right[~confident].mean() + 0.3


def test_training_is_repeatable(small):
    again = train_confidence(small.described, small.regressor)
    np.testing.assert_array_equal(again.calibration.weights, small.confidence.calibration.weights)


def test_a_model_keeps_its_confidence(small, tmp_path):
    model = small.described.model(small.regressor)
    model.save(tmp_path / "model.npz")
    masks = small.described.data.test[0].masks[:6]
    loaded, own = load(tmp_path / "model.npz").predict(masks), model.predict(masks)
    np.testing.assert_array_equal(loaded.confidence, own.confidence)
    assert (own.confidence > 0.5).all()


def test_descriptors_alone_are_enough(small):
    data = small.described.data
    bare = [
        [replace(take, masks=None, z=z) for take, (z, _) in zip(takes, examples, strict=True)]
        for takes, examples in (
            (data.train, small.described.train),
            (data.test, small.described.test),
        )
    ]
    data = Dataset("bare", ANGLES, bare[0], [], bare[1])
    described = DescribedDataset(data, None, small.described.train, [], small.described.test)
    confidence = train_confidence(described, small.regressor)
    z, _ = small.described.test[0]
    assert np.mean(confidence.of(z, small.regressor.predict(z)) >= 0.5) > 0.9


@pytest.mark.parametrize("by_performer", [False, True])
def test_a_single_take_is_enough(small, by_performer):
    data = small.described.data
    data = Dataset("one", ANGLES, data.train[:1], [], [], by_performer)
    described = DescribedDataset(
        data, small.described.descriptor, small.described.train[:1], [], []
    )
    assert train_confidence(described, small.regressor).examples.roots.shape == (60, 40)
