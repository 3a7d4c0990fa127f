import numpy as np

from silpose.regression import MixtureOfRegressors
from silpose.regression.mixture.em import expectation_maximisation
from silpose.regression.mixture.experts import Experts, Prior
from silpose.regression.mixture.reduced_examples import ReducedArrays
from silpose.regression.mixture.shared_regressor import SharedFit


def test_em_does_not_lose_likelihood_between_prunings(two_valued):
    z, x, _ = two_valued(500)
    mixture = MixtureOfRegressors(40, hellinger=False, smallest=8, max_iter=40, tol=1e-9).fit(z, x)
    steps = np.diff(mixture.objective_)
    unpruned = [k for k in range(len(steps)) if k + 1 not in mixture.pruned_]
    assert len(unpruned) > 5
    assert steps[unpruned].min() > -1e-7


def test_components_of_few_examples_are_pruned(two_valued):
    z, x, branch = two_valued(300)
    labels = np.where(branch, 1, 0)
    labels[:3] = 2
    prior = Prior(5.0, np.ones(3), np.ones(2), 1.0, 0.1)
    start = Experts.fit(z, x, np.eye(3)[labels], prior)
    examples = ReducedArrays(z, z, x, SharedFit.of)
    experts, _, pruned = expectation_maximisation(examples, start, prior, 10.0, 30, 1e-9)
    assert len(pruned) == 1
    assert sorted(np.sign(experts.offsets[:, 0])) == [-1, 1]
