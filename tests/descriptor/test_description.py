import numpy as np
import pytest

from silpose.descriptor import ShapeContextHistogram
from silpose.descriptor.description import BOUNDARIES, EdgeContexts
from silpose.descriptor.subpixel import LATTICE_SIZE

SQUARE = np.zeros((60, 60), np.uint8)
SQUARE[10:50, 10:50] = 1


def extractor(boundary, **parameters):
    return EdgeContexts.of(ShapeContextHistogram(boundary=boundary, **parameters))


def test_edge_points_are_by_number_by_spacing_or_everywhere():
    edge = extractor("pixels", edge_points=20).edge(SQUARE)
    assert (len(edge.lattice), len(edge.points)) == (4 * 39, 20)
    np.testing.assert_array_equal(edge.lattice[edge.chosen], edge.points)
    assert edge.size == pytest.approx(np.sqrt(edge.lattice.var(axis=0).sum()))
    spaced = extractor("pixels", spacing=0.5).edge(SQUARE)
    assert len(spaced.points) == round(4 * 39 / (0.5 * edge.size))
    everywhere = extractor("pixels", edge_points=None).edge(SQUARE)
    np.testing.assert_array_equal(everywhere.lattice, everywhere.points)


def test_edge_points_between_pixels_are_by_number_by_spacing_or_everywhere():
    edge = extractor("subpixel", edge_points=20).edge(SQUARE)
    assert (len(edge.chosen), edge.points.shape) == (20, (20, 2))
    inside = np.abs(edge.points - 29.5).max(axis=1)
    assert inside == pytest.approx(20, abs=1)  # the square's sides, 40 apart
    spaced = extractor("subpixel", spacing=0.5).edge(SQUARE)
    assert len(spaced.chosen) == round(len(edge.lattice) / (0.5 * LATTICE_SIZE))
    everywhere = extractor("subpixel", edge_points=None).edge(SQUARE)
    np.testing.assert_array_equal(everywhere.chosen, np.arange(len(everywhere.lattice)))
    assert len(extractor("subpixel", edge_points=5000).edge(SQUARE).points) == 5000


@pytest.mark.parametrize("boundary", BOUNDARIES)
def test_rings_are_relative_to_the_silhouettes_size(boundary):
    parameters = {"radius": 0.8, "inner_radius": 0.1, "radial_bins": 3}
    edge = extractor(boundary, **parameters).edge(SQUARE)
    rings = extractor(boundary, **parameters).rings(edge)
    assert rings[[0, -1]] == pytest.approx([0.08 * edge.size, 0.8 * edge.size])


def test_a_single_pixel_has_a_ring_of_its_own():
    one = extractor("pixels")
    assert one.rings(one.edge(np.ones((1, 1), np.uint8)))[-1] == 1


@pytest.mark.parametrize("boundary", BOUNDARIES)
def test_contexts_have_a_row_for_every_point(boundary):
    one = extractor(boundary, angular_bins=6, radial_bins=4)
    edge = one.edge(SQUARE)
    contexts = one.contexts(edge, edge.chosen, one.rings(edge))
    assert contexts.shape == (200, 24)
    np.testing.assert_allclose(contexts.sum(axis=1), 1, atol=1e-6)
