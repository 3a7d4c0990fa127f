import numpy as np
import pytest

from silpose.regression.moments import Moments


@pytest.fixture
def examples():
    """Basis functions (200, 4) and outputs (200, 3) far from zero; the last is constant."""
    rng = np.random.default_rng(0)
    y = np.column_stack([1e6 + rng.normal(size=(200, 2)), np.full(200, 1 / 3)])
    return rng.normal(size=(200, 4)) - 1e5, y


def test_they_are_products_of_deviations(examples):
    f, y = examples
    moments = Moments.of(f, y)
    covariance = np.cov(np.hstack([f, y]).T, bias=True) * 200
    assert moments.gram == pytest.approx(covariance[:4, :4], rel=1e-6)
    assert moments.cross == pytest.approx(covariance[:4, 4:], rel=1e-6, abs=1e-5)
    assert moments.squares == pytest.approx(covariance.diagonal()[4:], rel=1e-6, abs=1e-5)
    scale, varies = moments.scales
    assert varies.tolist() == [True, True, False]
    assert scale == pytest.approx([*y[:, :2].std(axis=0), 1.0])


@pytest.mark.parametrize("rows", [1, 7, 150])
def test_blocks_add_up_without_cancellation(examples, rows):
    f, y = examples
    parts = [Moments.of(f[k : k + rows], y[k : k + rows]) for k in range(0, 200, rows)]
    first = parts[0].gram.copy()
    total, whole = Moments.total(parts), Moments.of(f, y)
    assert np.array_equal(parts[0].gram, first)  # what comes from a worker may be read-only
    assert total.count == 200
    for name in ("mean_f", "mean_y", "gram", "low", "high"):
        assert getattr(total, name) == pytest.approx(getattr(whole, name), rel=1e-9, abs=1e-7)
    assert total.squares[:2] == pytest.approx(whole.squares[:2], rel=1e-9)
    assert total.scales[1].tolist() == [True, True, False]


def test_outputs_alone_have_moments(examples):
    _, y = examples
    alone = Moments.of_outputs(y)
    assert alone.gram.shape == (0, 0)
    assert alone.mean_y == pytest.approx(y.mean(axis=0))
