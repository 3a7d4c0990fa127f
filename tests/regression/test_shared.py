import numpy as np
import pytest

from silpose.regression import MixtureOfRegressors, RidgeRegressor
from silpose.regression.saved_mixture import mixture_from, mixture_state
from silpose.regression.shared import SharedRegressor


@pytest.fixture
def examples():
    random = np.random.default_rng(0)
    z = random.random((300, 4))
    x = np.column_stack([z.sum(axis=1), random.choice([-1.0, 1.0], 300)])
    return z, x + 0.01 * random.standard_normal(x.shape)


def test_is_heeded_where_it_errs_little(examples):
    shared = SharedRegressor.fit(RidgeRegressor(), *examples)
    heed = shared.heed(np.full((3, 2), 0.05), width=1.0)
    assert heed.shape == (3, 2)
    assert (heed[:, 0] > 0.9).all() and (heed[:, 1] < 0.1).all()
    assert (shared.heed(np.full((3, 2), 0.05), width=100.0) < heed).all()


def test_answers_move_towards_it_between_its_estimate_and_their_own(examples):
    z, x = examples
    apart, together = (
        MixtureOfRegressors(5, shared=shared, shared_width=1.0).fit(z, x)
        for shared in (None, RidgeRegressor())
    )
    unseen = np.random.default_rng(1).random((20, 4))
    own, moved = (m.answers(unseen[0])[1][:-1] for m in (apart, together))
    said = RidgeRegressor().fit(z, x).predict(unseen[:1])[0]
    assert np.abs(moved[:, 0] - said[0]).max() < np.abs(own[:, 0] - said[0]).max()
    assert np.abs(moved[:, 1] - own[:, 1]).max() < 0.1 * np.abs(moved[:, 1] - said[1]).max()
    restored = mixture_from(mixture_state(together))
    assert restored.predict(unseen) == pytest.approx(together.predict(unseen))
