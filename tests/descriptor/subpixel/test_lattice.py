import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from silpose.descriptor.boundary import boundary_pixels
from silpose.descriptor.subpixel import LATTICE_SIZE, NO_EDGES, lattice_boundary
from silpose.descriptor.subpixel.lattice import smoothed


def boundary_of(mask):
    return lattice_boundary(*boundary_pixels(mask))


def disc(radius, size):
    y, x = np.indices((size, size)) - (size - 1) / 2
    return (np.hypot(x, y) <= radius).astype(np.uint8)


@pytest.mark.parametrize("radius", [6, 12, 50, 200])
def test_a_disc_is_round_at_any_resolution(radius):
    boundary = boundary_of(disc(radius, 2 * radius + 9))
    assert np.linalg.norm(boundary.lattice, axis=1) == pytest.approx(LATTICE_SIZE, rel=0.1)
    assert boundary.unit * LATTICE_SIZE == pytest.approx(radius, rel=0.03)
    assert len(boundary.lattice) == pytest.approx(2 * np.pi * LATTICE_SIZE, rel=0.08)


def test_points_are_a_unit_apart_and_in_place(sequence):
    mask = sequence.masks[3]
    boundary = boundary_of(mask)
    (count,) = boundary_pixels(mask)[1]
    assert count > 0  # one contour
    steps = np.linalg.norm(np.diff(boundary.pixels, axis=0), axis=1) / boundary.unit
    assert steps == pytest.approx(1, abs=0.3)  # shorter only where the boundary bends
    size = np.sqrt(boundary.lattice.var(axis=0).sum())
    assert size == pytest.approx(LATTICE_SIZE, rel=0.01)
    centre = boundary.pixels.mean(axis=0)
    rounding = boundary.pixels - centre - boundary.unit * boundary.lattice
    assert np.abs(rounding).max() < boundary.unit
    assert boundary.farthest == np.abs(boundary.lattice[:, 0]).max()


@settings(deadline=None, max_examples=100)
@given(
    arrays(
        np.uint8, st.tuples(st.integers(1, 20), st.integers(1, 20)), elements=st.integers(0, 1)
    ).filter(np.any),
    st.tuples(st.integers(0, 9), st.integers(0, 9)),
)
def test_moving_a_mask_moves_its_boundary(mask, shift):
    here, there = boundary_of(mask), boundary_of(np.pad(mask, [(n, 3) for n in shift]))
    np.testing.assert_array_equal(here.lattice, there.lattice)
    np.testing.assert_allclose(here.pixels + shift[::-1], there.pixels)
    assert here.unit == there.unit


@pytest.mark.parametrize("factor", [2, 3, 5])
def test_enlarging_a_mask_enlarges_its_boundary(sequence, factor):
    mask = sequence.masks[3]
    large = np.repeat(np.repeat(mask, factor, axis=0), factor, axis=1)
    here, there = boundary_of(mask), boundary_of(large)
    np.testing.assert_array_equal(here.lattice, there.lattice)
    np.testing.assert_allclose((here.pixels + 0.5) * factor - 0.5, there.pixels)
    assert there.unit == pytest.approx(factor * here.unit)


def test_smoothing_keeps_lines_and_removes_stairs():
    n = np.arange(400)
    circle = np.stack([np.cos(n * np.pi / 200), np.sin(n * np.pi / 200)], axis=1)
    counts = np.array([400], np.int32)
    np.testing.assert_allclose(smoothed(circle, counts), circle, atol=1e-5)
    zigzag = np.stack([n, 0.25 * (-1.0) ** n], axis=1)
    assert np.abs(smoothed(zigzag, counts)[2:-2] - (zigzag * (1, 0))[2:-2]).max() < 1e-9


@pytest.mark.parametrize("counts", [[4], [5], [1], [2, 3], [4, 4]])
def test_small_contours_are_smoothed_as_closed_curves(counts):
    points = np.random.default_rng(0).random((sum(counts), 2))
    smooth = smoothed(points, np.array(counts, np.int32))
    for own, before in zip(
        np.split(smooth, np.cumsum(counts)[:-1]),
        np.split(points, np.cumsum(counts)[:-1]),
        strict=True,
    ):
        near = [np.roll(before, k, axis=0) for k in (-2, -1, 0, 1, 2)]
        weights = np.array([-1, 4, 10, 4, -1]) / 16
        np.testing.assert_allclose(own, np.tensordot(weights, near, axes=1))


def test_no_point_lies_along_an_edge_that_cuts(sequence):
    mask = sequence.masks[7]
    rows = np.flatnonzero(mask.any(axis=1))
    knees = mask[: rows[0] + round(0.75 * len(rows))]
    bottom = len(knees) - 0.5
    outline = boundary_pixels(knees)
    closed = lattice_boundary(*outline)
    edges = np.array([-np.inf, -np.inf, np.inf, bottom])
    opened = lattice_boundary(*outline, edges)
    along = np.abs(closed.pixels[:, 1] - bottom) < 0.25
    assert along.any()
    assert opened.pixels[:, 1].max() < bottom - 0.25
    assert opened.unit == closed.unit
    assert len(opened.pixels) == pytest.approx((~along).sum(), abs=6)
    np.testing.assert_array_equal(lattice_boundary(*outline, NO_EDGES).lattice, closed.lattice)


def test_a_boundary_that_lies_along_edges_alone_is_kept():
    outline = boundary_pixels(np.ones((9, 7), np.uint8))
    whole = lattice_boundary(*outline, np.array([-0.5, -0.5, 6.5, 8.5]))
    np.testing.assert_array_equal(whole.lattice, lattice_boundary(*outline).lattice)
