import numpy as np

from silpose.dataset import Dataset, degraded
from silpose.pose import ANGLES
from silpose.silhouette import Degradation


def test_each_split_suffers_what_it_is_to(sequence):
    takes = [type(sequence)(**{**vars(sequence), "name": name}) for name in ("a", "b", "c")]
    data = Dataset("three", ANGLES, *([take] for take in takes))
    spoilt = degraded(data, Degradation(test=["holes"]))
    assert spoilt.train is data.train
    assert (spoilt.test[0].masks != sequence.masks).any(axis=(1, 2)).all()
    np.testing.assert_array_equal(spoilt.test[0].x, sequence.x)
    spoilt = degraded(data, Degradation(train=["frame_cut"]))
    assert spoilt.test is data.test
    for take in (*spoilt.train, *spoilt.validation):
        assert (take.masks != sequence.masks).any(axis=(1, 2)).all()
