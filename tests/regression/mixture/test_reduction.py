import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.regression.mixture import PoseDirections, whitening


def test_whitening_divides_by_the_scatter_and_its_mean():
    residuals = np.random.default_rng(0).normal(size=(500, 3)) * [0.1, 1.0, 5.0]
    whitened = residuals @ whitening(residuals.T @ residuals / 500)
    scatter = np.linalg.eigvalsh(residuals.T @ residuals / 500)
    expected = np.diag(scatter / (scatter + scatter.mean()))
    assert whitened.T @ whitened / 500 == pytest.approx(expected, abs=1e-9)


def test_the_first_direction_is_what_varies_with_the_pose_not_what_varies_most():
    rng = np.random.default_rng(0)
    pose = rng.normal(size=(400, 1))
    z = np.column_stack([10 * rng.normal(size=400), 3 * pose[:, 0], rng.normal(size=(400, 18))])
    psi = PoseDirections(1, hellinger=False).fit(z, pose).transform(z)
    assert psi.shape == (400, 1)
    assert abs(np.corrcoef(psi[:, 0], pose[:, 0])[0, 1]) > 0.9


def test_only_histograms_have_square_roots():
    z = np.random.default_rng(0).dirichlet(np.ones(5), 40)
    reduction = PoseDirections(2).fit(z, z)
    assert reduction.transform(z).mean(axis=0) == pytest.approx([0, 0], abs=1e-9)
    with pytest.raises(InputError, match="hellinger=False"):
        reduction.transform(-z)
