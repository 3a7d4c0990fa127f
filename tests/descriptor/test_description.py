import numpy as np
import pytest

from silpose.descriptor import ShapeContextHistogram
from silpose.descriptor.description import EdgeContexts

SQUARE = np.zeros((60, 60), np.uint8)
SQUARE[10:50, 10:50] = 1


def extractor(**parameters):
    return EdgeContexts.of(ShapeContextHistogram(**parameters))


def test_edge_points_are_by_number_by_spacing_or_everywhere():
    pixels, points = extractor(edge_points=20).edge(SQUARE)
    assert (len(pixels), len(points)) == (4 * 39, 20)
    size = np.sqrt(pixels.var(axis=0).sum())
    spaced = extractor(spacing=0.5).edge(SQUARE)[1]
    assert len(spaced) == round(4 * 39 / (0.5 * size))
    np.testing.assert_array_equal(*extractor(edge_points=None).edge(SQUARE))


def test_rings_are_relative_to_the_silhouettes_size():
    parameters = {"radius": 0.8, "inner_radius": 0.1, "radial_bins": 3}
    pixels, _ = extractor(**parameters).edge(SQUARE)
    size = np.sqrt(pixels.var(axis=0).sum())
    rings = extractor(**parameters).rings(pixels)
    assert rings[[0, -1]] == pytest.approx([0.08 * size, 0.8 * size])
    assert extractor().rings(pixels[:1])[-1] == 1  # of a single pixel


def test_contexts_have_a_row_for_every_point():
    one = extractor(angular_bins=6, radial_bins=4)
    pixels, points = one.edge(SQUARE)
    contexts = one.contexts(pixels, points, one.rings(pixels))
    assert contexts.shape == (200, 24)
    np.testing.assert_allclose(contexts.sum(axis=1), 1, atol=1e-6)
