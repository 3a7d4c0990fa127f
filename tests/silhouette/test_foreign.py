import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from silpose.silhouette import FOREIGN, foreign_shape


@settings(deadline=None, max_examples=100)
@given(
    st.integers(1, 200), st.integers(1, 200), st.floats(1, 300), st.sampled_from(list(FOREIGN)),
    st.integers(0, 99),
)  # fmt: skip
def test_any_shape_is_a_mask_that_is_not_blank(height, width, tall, kind, seed):
    mask = foreign_shape(height, width, tall, np.random.default_rng(seed), kind)
    assert mask.shape == (height, width) and mask.dtype == np.uint8
    assert set(np.unique(mask)) <= {0, 1} and mask.any()


def test_draws_depend_on_the_generator_alone():
    one, two = (foreign_shape(96, 96, 70, np.random.default_rng(3)) for _ in range(2))
    np.testing.assert_array_equal(one, two)


@pytest.mark.parametrize("kind", ["disc", "box", "chair", "tree", "dog"])
def test_shapes_are_about_as_tall_as_a_person(kind):
    rng = np.random.default_rng(0)
    masks = [foreign_shape(256, 256, 120, rng, kind) for _ in range(20)]
    tall = [np.ptp(np.flatnonzero(mask.any(axis=1))) for mask in masks]
    assert 40 < np.median(tall) < 200
