import numpy as np
import pytest
from scipy.stats import norm

from silpose.regression.mixture.experts import Experts, Prior


@pytest.fixture
def fitted(two_valued):
    z, x, branch = two_valued(200)
    shares = np.column_stack([branch, ~branch]).astype(float)
    prior = Prior(1e-6, np.ones(3), np.ones(2), 1e-6, 1e-3)
    return Experts.fit(z, x, shares, prior), z, x, branch, prior


def test_the_m_step_fits_each_component_to_its_examples(fitted):
    experts, z, x, branch, _ = fitted
    assert np.exp(experts.log_shares) == pytest.approx([branch.mean(), 1 - branch.mean()])
    for k, own in enumerate((branch, ~branch)):
        design = np.column_stack([z[own] - z[own].mean(axis=0), np.ones(own.sum())])
        expected = np.linalg.lstsq(design, x[own], rcond=None)[0]
        assert np.vstack([experts.slopes[k], experts.offsets[k]]) == pytest.approx(
            expected, abs=1e-5
        )
        assert experts.centres[k] == pytest.approx(z[own].mean(axis=0))
        assert experts.spreads[k] == pytest.approx(z[own].var(axis=0), rel=1e-5)


def test_the_e_step_is_bayes_rule(fitted):
    experts, z, x, _, _ = fitted
    shares, _ = experts.responsibilities(z, x)
    means = experts.means(z, np.arange(2))
    joint = experts.log_shares + np.stack([
        norm.logpdf(z, experts.centres[k], np.sqrt(experts.spreads[k])).sum(axis=1)
        + norm.logpdf(x, means[:, k], np.sqrt(experts.noises[k])).sum(axis=1)
        for k in range(2)
    ], axis=1)  # fmt: skip
    expected = np.exp(joint - np.logaddexp.reduce(joint, axis=1, keepdims=True))
    assert shares == pytest.approx(expected, abs=1e-12)


def test_typical_variances_are_those_within_clusters():
    inputs, poses = np.array([[0.0], [2.0], [10.0], [14.0]]), np.array([[1.0], [1.0], [5.0], [9.0]])
    prior = Prior.typical(inputs, poses, np.array([0, 0, 1, 1]), 1.0, 0.1)
    assert prior.spread == pytest.approx([(1 + 1 + 4 + 4) / 4])
    assert prior.noise == pytest.approx([(4 + 4) / 4])
