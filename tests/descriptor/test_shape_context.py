import numpy as np
import pytest
import reference
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from silpose.descriptor.boundary import boundary_pixels
from silpose.descriptor.shape_context import ContextBins, ring_bounds, sector_table, shape_contexts


def contexts(mask, reach=20.0, inner=2.0, angular=12, radial=5, keep=False):
    pixels, _ = boundary_pixels(mask)
    bounds = ring_bounds(reach, inner, radial)
    bins = ContextBins.of(bounds, angular, np.ptp(pixels[:, 0]), keep)
    return pixels, shape_contexts(pixels, pixels, bins)


@settings(deadline=None, max_examples=50)
@given(
    arrays(np.uint8, st.tuples(st.integers(1, 30), st.integers(1, 30)), elements=st.integers(0, 1)),
    st.floats(1, 60),
    st.floats(0.02, 0.9),
    st.integers(1, 16),
    st.integers(2, 7),
    st.booleans(),
)
def test_agrees_with_the_definition(mask, reach, share, angular, radial, keep):
    if not mask.any():
        return
    pixels, found = contexts(mask, reach, share * reach, angular, radial, keep)
    expected = reference.contexts(pixels, pixels, reach, share * reach, angular, radial)
    np.testing.assert_allclose(found, expected, atol=1e-6)


def test_rings_grow_by_equal_factors():
    bounds = ring_bounds(100.0, 10.0, 5)
    np.testing.assert_allclose(bounds[1:] / bounds[:-1], bounds[1] / bounds[0])
    assert bounds[[0, -1]] == pytest.approx([10, 100])


def test_the_first_sector_looks_right_and_the_next_down():
    sectors = sector_table(10, 12)
    assert sectors[10, 20] == 0  # +x
    assert sectors[20, 10] == 3  # +y is down: a quarter turn
    assert sectors[10, 0] == 6
    assert sectors[0, 10] == 9


def test_contexts_are_not_rotated():
    upright = np.zeros((60, 60), np.uint8)
    upright[10:50, 25:35] = 1
    lying = np.ascontiguousarray(upright.T)
    standing = contexts(upright)[1].mean(axis=0)
    assert np.abs(standing - contexts(lying)[1].mean(axis=0)).max() > 0.05
