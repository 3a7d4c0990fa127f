import numpy as np
import pytest

from silpose.fitting.parameters import ANGLES, ELEVATION
from silpose.fitting.take_fit import _Chain


def dense(chain, hessians, gradients, errors, prior, step_seconds, free):
    """Minimise over all frames, the lasting error and the shared parameters as one vector."""
    frames, width = len(errors), chain.width
    shared = errors.shape[1] - width
    size = frames * width + ANGLES + shared
    system, right = np.zeros((size, size)), np.zeros(size)
    own = [np.arange(t * width, (t + 1) * width) for t in range(frames)]
    lasting = np.arange(frames * width, frames * width + ANGLES)
    alike = np.arange(size - shared, size)

    def add(weights, precision):
        """Add |Σ weight · part|² under a precision."""
        for i, a in weights:
            for j, b in weights:
                system[np.ix_(i, j)] += a * b * precision

    phi, precision = np.exp(-step_seconds / prior.seconds), prior.precision
    first = precision / (1 - prior.lasting)
    add([(own[0][:ANGLES], 1), (lasting, -1)], first)
    for t in range(1, frames):
        parts = [(own[t][:ANGLES], 1), (own[t - 1][:ANGLES], -phi), (lasting, phi - 1)]
        add(parts, first / (1 - phi**2))
    add([(lasting, 1)], precision / prior.lasting)
    add([(alike, 1)], np.diag(free[width - ANGLES :]))
    for t in range(frames):
        add([(own[t][ANGLES:], 1)], np.diag(free[: width - ANGLES]))
        every = np.concatenate([own[t], alike])
        system[np.ix_(every, every)] += hessians[t]
        right[every] += gradients[t] + hessians[t] @ errors[t]
    solved, covariance = np.linalg.solve(system, right), np.linalg.inv(system)
    new = np.stack([np.concatenate([solved[o], solved[alike]]) for o in own])
    return new, np.stack([covariance[np.ix_(o[:ANGLES], o[:ANGLES])] for o in own])


@pytest.mark.parametrize("free", [0, 14])
def test_the_chain_is_the_dense_solution(prior, free):
    rng = np.random.default_rng(0)
    size = ANGLES + free
    rows = rng.normal(size=(5, 20, size))
    hessians = np.einsum("tki,tkj->tij", rows, rows)
    gradients = rng.normal(size=(5, size)) * 10
    errors = rng.normal(size=(5, size)) * 0.1
    errors[:, min(size, ELEVATION) :] = errors[0, min(size, ELEVATION) :]
    precision = rng.uniform(1, 5, free)
    chain = _Chain(prior, 1 / 15, 5, precision)
    new, covariances = chain.solve(hessians, gradients, errors)
    wanted = dense(chain, hessians, gradients, errors, prior, 1 / 15, precision)
    assert new == pytest.approx(wanted[0], abs=1e-8)
    assert covariances == pytest.approx(wanted[1], abs=1e-8)
