import numpy as np
import pytest

from silpose.regression.mixture.expert_sums import ExpertSums


@pytest.fixture
def examples():
    rng = np.random.default_rng(0)
    shares = rng.dirichlet(np.full(4, 0.05), 300)
    shares[:100, 3] = 0  # the first block has none of the last component
    return 5 + rng.normal(size=(300, 3)), rng.normal(size=(300, 2)) - 9, shares


def test_they_are_weighted_moments_of_what_is_not_ignored(examples):
    psi, poses, shares = examples
    sums = ExpertSums.of(psi, poses, shares)
    weights = np.where(shares > 1e-6, shares, 0)
    for k, weight in enumerate(weights.T):
        assert sums.size[k] == pytest.approx(shares[:, k].sum())
        assert sums.mean_f[k] == pytest.approx(np.average(psi, axis=0, weights=weight))
        both = np.cov(np.hstack([psi, poses]).T, aweights=weight, ddof=0) * weight.sum()
        assert sums.gram[k] == pytest.approx(both[:3, :3])
        assert sums.cross[k] == pytest.approx(both[:3, 3:])
        assert sums.squares[k] == pytest.approx(both.diagonal()[3:])


def test_sums_over_blocks_add_up(examples):
    whole, blocks = ExpertSums.of(*examples), None
    for start in range(0, 300, 60):
        part = ExpertSums.of(*(values[start : start + 60] for values in examples))
        if blocks is None:
            blocks = part
        else:
            blocks.add(part)
    for name, value in vars(whole).items():
        assert getattr(blocks, name) == pytest.approx(value, rel=1e-10, abs=1e-10), name
