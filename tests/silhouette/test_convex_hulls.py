import cv2
import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from silpose.silhouette.convex_hulls import convex_hulls

# Few places, so that points coincide and lie on lines, and ones far out of the picture.
PLACES = st.one_of(st.integers(-3, 3), st.integers(-(2**30), 2**30))


SHAPES = st.tuples(st.integers(1, 3), st.integers(1, 9), st.just(2))


@given(arrays(np.int32, SHAPES, elements=PLACES))
def test_corners_are_those_that_opencv_finds(pieces):
    hulls, counts = convex_hulls(pieces)
    for piece, hull, count in zip(pieces, hulls, counts, strict=True):
        corners = set(map(tuple, hull[:count].tolist()))
        assert len(corners) == count
        assert corners <= set(map(tuple, piece.tolist()))
        area = cv2.contourArea(hull[:count].astype(np.float32))
        hull_of_opencv = cv2.convexHull(piece.astype(np.float32))
        assert np.isclose(area, cv2.contourArea(hull_of_opencv), rtol=1e-4, atol=1e-4)


def test_corners_follow_one_another_without_those_on_lines():
    square = np.array([[[2, 0], [1, 1], [0, 0], [2, 2], [1, 0], [0, 2], [0, 0]]], np.int32)
    hulls, counts = convex_hulls(square)
    assert counts == [4]
    corners = hulls[0, :4].tolist()
    start = corners.index([0, 0])
    around = corners[start:] + corners[:start]
    assert around in ([[0, 0], [2, 0], [2, 2], [0, 2]], [[0, 0], [0, 2], [2, 2], [2, 0]])
