import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.fitting import EVIDENCE, Confidence

GOOD = np.array([np.log(0.05), 0.1, 0.7, 0.0, 1.0, np.log(0.05), -1.0, 0.0, 0.0])
"""Evidence of a body that explains its mask."""


def changed(**values):
    evidence = GOOD.copy()
    for name, value in values.items():
        evidence[EVIDENCE.index(name)] = value
    return evidence


def test_it_is_high_where_all_speaks_for_a_pose():
    assert Confidence().of(GOOD[None])[0] > 0.9


@pytest.mark.parametrize(
    "against", [{"unexplained": np.log(0.6), "misfit": 1.0, "deviation": 4.0}, {"turning": -1.0}]
)
def test_it_falls_with_what_speaks_against_a_pose(against):
    confidence = Confidence()
    assert confidence.of(changed(**against)[None])[0] < confidence.of(GOOD[None])[0] - 0.05


def test_without_evidence_it_is_0():
    evidence = np.stack([GOOD, np.full(len(EVIDENCE), np.nan)])
    confidence = Confidence().of(evidence)
    assert confidence[1] == 0 < confidence[0] < 1


def test_an_overlap_is_judged_by_what_is_usual():
    evidence = changed(unexplained=np.log(0.15))[None]
    assert Confidence(usual_iou=0.85).of(evidence)[0] > Confidence(usual_iou=0.97).of(evidence)[0]


def test_learned_it_is_as_often_right_as_it_says():
    rng = np.random.default_rng(0)
    evidence = rng.normal(0, 1, (3000, len(EVIDENCE)))
    likely = 1 / (1 + np.exp(-(0.5 + 2 * evidence[:, 2])))
    right = rng.random(3000) < likely
    learned = Confidence((0.0,) * (1 + len(EVIDENCE))).learned_from(evidence, right)
    assert learned.weights[1 + 2] == pytest.approx(2, abs=0.3)
    sure = learned.of(evidence)
    for low, high in ((0, 0.3), (0.3, 0.7), (0.7, 1)):
        own = (sure >= low) & (sure < high)
        assert right[own].mean() == pytest.approx(sure[own].mean(), abs=0.06)


def test_little_to_learn_from_changes_little():
    expected = Confidence()
    learned = expected.learned_from(GOOD[None], np.array([True]))
    np.testing.assert_allclose(learned.weights, expected.weights, atol=0.1)


def test_another_number_of_weights_is_refused():
    with pytest.raises(InputError, match="10 weights, not 3"):
        Confidence((1.0, 2.0, 3.0))
