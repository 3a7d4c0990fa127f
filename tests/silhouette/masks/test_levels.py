import numpy as np
import pytest

from silpose.silhouette.masks.levels import Levels


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.int64, np.float32])
def test_values_are_the_sources_own(figures, kind):
    levels = Levels.of([7 * mask.astype(kind) for mask in figures])
    assert levels.exact
    np.testing.assert_array_equal(levels.present, [0, 7])
    people = sum(mask.sum() for mask in figures)
    assert levels.count[levels.values == 7] == people
    assert levels.border.sum() == 6 * 2 * (48 + 40) and levels.border[levels.values == 7] == 0


def test_of_many_values_steps_are_counted():
    values = np.linspace(-3, 5, 1000).reshape(20, 50)
    levels = Levels.of([values])
    assert not levels.exact and len(levels.values) == 256
    np.testing.assert_allclose(levels.values[[0, -1]], [-3, 5])
    assert levels.count.sum() == 1000


def test_edges_are_between_and_areas_flat():
    picture = np.zeros((9, 12), np.uint8)
    picture[:, 5], picture[:, 6:] = 100, 200
    levels = Levels.of([picture])
    assert levels.between[100] == 9 and levels.flat[100] == 0
    assert levels.flat[0] == 9 * 4 and levels.flat[200] == 9 * 5


def test_pictures_of_one_value_tell_nothing_of_the_border():
    assert Levels.of([np.full((5, 5), 255, np.uint8)]).border.sum() == 0
