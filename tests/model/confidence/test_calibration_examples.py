from dataclasses import replace

import numpy as np

from silpose.core.known_results import KnownResults
from silpose.core.pose_space import ANGLES
from silpose.dataset import Dataset
from silpose.model.confidence import train_confidence
from silpose.model.confidence.calibration_examples import (
    CalibrationExamples,
    left_out,
    parts_of,
)


def test_examples_are_made_once_for_all_regressors(small, tmp_path, monkeypatch):
    kept = replace(small.described, known=KnownResults(tmp_path))
    first = train_confidence(kept, small.regressor)
    np.testing.assert_array_equal(first.calibration.weights, small.confidence.calibration.weights)
    monkeypatch.setattr(CalibrationExamples, "_made", None)  # would fail
    again = train_confidence(kept, small.regressor)
    np.testing.assert_array_equal(again.calibration.weights, first.calibration.weights)


def test_other_masks_have_other_examples(small, tmp_path):
    kept = replace(small.described, known=KnownResults(tmp_path))
    CalibrationExamples.of(kept)
    CalibrationExamples.of(replace(kept, train=[(z, 2 * x) for z, x in kept.train]))
    assert len(list(tmp_path.glob("*.npz"))) == 2


def test_many_performers_are_left_out_in_a_few_parts(small):
    data = small.described.data
    takes = [replace(take, performer=take.name) for take in data.train] * 3
    takes = [
        replace(take, name=f"{k}", performer=f"{k}", source=f"{k}") for k, take in enumerate(takes)
    ]
    described = replace(
        small.described,
        data=Dataset("many", ANGLES, takes, [], [], True),
        train=[*small.described.train] * 3,
    )
    parts = left_out(described)
    assert len(parts) <= 4
    assert sorted(k for part in parts for k in part) == list(range(18))
    assert len(parts_of(described)) == len(parts)


def test_validation_takes_are_judged_too(small):
    data, (z, x) = small.described.data, small.described.test[0]
    described = replace(
        small.described,
        data=Dataset("validated", ANGLES, data.train[:1], data.test, []),
        train=small.described.train[:1],
        validation=[(z, x)],
    )
    ((takes, _, rest),) = parts_of(described)
    assert takes == data.test and rest == [0]
