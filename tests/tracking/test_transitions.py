import numpy as np
import pytest
from scipy.sparse import csr_array

from silpose.tracking.transitions import Transitions

RESTART = 1e-6


@pytest.fixture
def ring():
    """60 key poses on a ring, each followed by itself and the next two."""
    steps = enumerate((0.2, 0.5, 0.3))
    near = sum(share * np.roll(np.eye(60), step, axis=1) for step, share in steps)
    return near, Transitions.of(csr_array(near), RESTART)


@pytest.fixture
def beliefs():
    """One that is certain, one that is open, one between."""
    rng = np.random.default_rng(0)
    return rng.dirichlet(np.full(60, 0.01)), np.full(60, 1 / 60), rng.dirichlet(np.ones(60))


def test_they_are_near_ones_and_restarts(ring):
    near, transitions = ring
    whole = (1 - RESTART) * near + RESTART / 60
    assert transitions.dense() == pytest.approx(whole, rel=1e-12)
    assert transitions.near.nnz == 3 * 60


def test_predictions_are_those_of_the_whole_matrix(ring, beliefs):
    whole = ring[1].dense()
    for belief in beliefs:
        assert ring[1].forward(belief) == pytest.approx(belief @ whole, rel=1e-6)
    seen = np.random.default_rng(1).random((4, 60))
    assert ring[1].backward(seen) == pytest.approx(seen @ whole.T, rel=1e-12)


def test_of_very_many_improbable_ones_restart(ring, beliefs, monkeypatch):
    monkeypatch.setattr("silpose.tracking.transitions.FEW", 20)
    whole = ring[1].dense()
    for belief in beliefs:
        predicted = ring[1].forward(belief)
        assert predicted.sum() == pytest.approx(1)
        assert predicted == pytest.approx(belief @ whole, abs=RESTART / 60)


def test_what_is_dropped_is_a_millionth_of_what_restarts_leave():
    assert Transitions.negligible(1000, 1e-3) == pytest.approx(1e-12)
    assert Transitions.negligible(1000, 0.0) == Transitions.negligible(1000, 1e-6)


@pytest.mark.parametrize("sparse", [True, False])
def test_time_reversed_twice_is_time(sparse, monkeypatch):
    monkeypatch.setattr("silpose.tracking.transitions._DENSE", float(sparse))
    rng = np.random.default_rng(1)
    joint = rng.random((4, 4))
    joint += joint.T  # so that leaving and arriving are as frequent
    sizes = joint.sum(axis=1)
    transitions = Transitions.of(csr_array(joint / sizes[:, None]), 0.1)
    assert isinstance(transitions.near, csr_array) == sparse
    backwards = transitions.reversed(sizes)
    expected = sizes[:, None] * transitions.dense()
    assert backwards.dense() == pytest.approx((expected / expected.sum(axis=0)).T)
    again = backwards.reversed(sizes @ transitions.dense())
    assert again.dense() == pytest.approx(transitions.dense())


def test_a_key_pose_that_none_leads_to_stays_when_time_is_reversed():
    transitions = Transitions.of(csr_array(np.array([[0.0, 1.0], [0.0, 1.0]])), 0.0)
    assert transitions.reversed(np.ones(2)).dense() == pytest.approx(np.array([[1, 0], [0.5, 0.5]]))


def test_they_survive_saving_and_those_of_older_models_are_read(ring, beliefs):
    _, transitions = ring
    arrays = {name: np.asarray(value) for name, value in transitions.to_arrays().items()}
    older = Transitions.of_dense(transitions.dense())
    dense = Transitions.from_arrays(older.to_arrays())
    for again in (Transitions.from_arrays(arrays), older, dense):
        for belief in beliefs:
            assert again.forward(belief) == pytest.approx(transitions.forward(belief), rel=1e-6)
