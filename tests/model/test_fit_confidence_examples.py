import numpy as np
import pytest
from synthetic import motion

from silpose.core.pose_space import ANGLES
from silpose.dataset import Dataset, render_take
from silpose.descriptor import ShapeContextHistogram
from silpose.fitting import EVIDENCE, FittingOptions
from silpose.model import FitterTraining, describe_dataset
from silpose.model.fit_confidence_examples import (
    CASES,
    confidence_examples,
    show,
)
from silpose.regression import RidgeRegressor


@pytest.fixture(scope="module")
def training(body, camera):
    takes = [render_take(motion(f"take{k}", 30, seed=k), body, camera) for k in range(4)]
    data = Dataset("small", ANGLES, takes[:3], [], takes[3:])
    described = describe_dataset(data, ShapeContextHistogram(codebook_size=30))
    ridge = RidgeRegressor(damping=0.1).fit(*described.joined("train"))
    options = FittingOptions(enabled=True, starts=1, iterations=4)
    return FitterTraining.of(described, ridge, options, body, camera)


def test_probabilities_of_cases_add_up():
    assert sum(CASES.values()) == pytest.approx(1)


def test_all_cases_are_shown(sequence, camera, body):
    rng = np.random.default_rng(0)
    shown = [show(sequence, camera, body, rng) for _ in range(60)]
    assert {own.case for own in shown} == set(CASES)
    for own in shown:
        assert {mask.shape for mask in own.masks} == {(96, 96)}
        assert (own.x is None) == (own.case == "foreign")


def test_examples_are_of_fits_to_takes_that_are_left_out(training):
    evidence, right, cases = confidence_examples(training, 5, np.random.default_rng(1))
    assert evidence.shape == (len(right), len(EVIDENCE)) and len(cases) == len(right)
    assert len(right) > 20 and np.isfinite(evidence).all()
    assert not right[[case == "foreign" for case in cases]].any()
