import numpy as np
import pytest

from silpose.tracking.belief_filter import BeliefFilter, expected_ahead, smooth, update
from silpose.tracking.transitions import Transitions


@pytest.fixture
def chain():
    """Transitions (5, 5) and likelihoods (8, 5) of a random hidden Markov chain."""
    rng = np.random.default_rng(0)
    return rng.dirichlet(np.ones(5), 5), rng.random((8, 5))


def forward(transitions, likelihoods):
    prediction, beliefs = np.full(5, 0.2), []
    for row in likelihoods:
        beliefs.append(update(prediction, row)[0])
        prediction = beliefs[-1] @ transitions
    return np.array(beliefs)


def by_enumeration(transitions, likelihoods, frame, last):
    """Probability (5,) of each state at a frame given what is seen up to the last."""
    weight = np.full(5, 0.2) * likelihoods[0]
    paths = np.diag(weight) if frame == 0 else None
    for t in range(1, last + 1):
        if paths is None:
            weight = weight @ transitions * likelihoods[t]
            paths = np.diag(weight) if t == frame else None
        else:
            paths = paths @ transitions * likelihoods[t]
    total = paths.sum(axis=1)
    return total / total.sum()


@pytest.mark.parametrize("lag", [0, 1, 3, 20])
def test_smoothing_gives_the_posterior(chain, lag):
    transitions = Transitions.of_dense(chain[0])
    smoothed = smooth(forward(*chain), expected_ahead(chain[1], transitions, lag))
    for frame in range(8):
        assert smoothed[frame] == pytest.approx(by_enumeration(*chain, frame, min(frame + lag, 7)))


def test_surprise_is_the_log_of_what_the_prediction_leaves():
    belief, surprise = update(np.array([0.25, 0.75]), np.array([1.0, 0.0]))
    assert belief == pytest.approx([1, 0])
    assert surprise == pytest.approx(-np.log(0.25))


def test_what_is_ruled_out_keeps_the_prediction():
    predicted = np.array([1.0, 0.0])
    belief, surprise = update(predicted, np.array([0.0, 1.0]))
    assert belief is predicted
    assert surprise == np.inf


def test_a_surprise_beyond_tolerance_is_lost_and_starts_anew():
    """Two key poses that never follow one another, facing to and from the camera."""
    never = Transitions.of_dense(np.eye(2))
    headings, prior = np.array([[1.0, 0.0], [-1.0, 0.0]]), np.full(2, 0.5)
    seen = np.array([[1.0, 1e-9], [1.0, 1e-9], [1e-9, 1.0], [1e-9, 1.0]])
    found = {}
    for recovers in (True, False):
        run = BeliefFilter(never, prior, headings, tolerance=2.0, recovers=recovers)
        steps = [run.step(row) for row in seen]
        found[recovers] = [state for _, state in steps], steps[-1][0].argmax()
    assert found[True] == (["tracking", "tracking", "lost", "recovered"], 1)
    assert found[False][0][2] == "lost"
