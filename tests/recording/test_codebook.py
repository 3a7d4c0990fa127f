import numpy as np

from silpose.recording import codebook_picture
from silpose.recording import entity_paths as entities


def test_a_centre_is_opaque_where_its_contour_lies():
    codebook = np.zeros((5, 60))
    codebook[0, 4 * 12] = 1  # the outermost ring, to the right
    codebook[1, 4 * 12 + 3] = 1  # and below
    picture = codebook_picture(codebook, 12)[..., 3].astype(int)
    assert picture.shape == (80, 120)  # 3 in a row
    right, below = picture[:40, :40], picture[:40, 40:80]
    assert right[20, 35] == right.max() > 3 * right[20, 5]
    assert below[35, 20] == below.max() > 3 * below[5, 20]
    assert picture[60, 100] == 0  # there is no sixth centre


def test_votes_are_bars_as_long_as_their_share(recordings, logged):
    strips = logged(recordings["context_space"], entities.VOTES, "LineStrips2D:strips")
    ends = np.array(strips)  # (F, K, 2, 2)
    assert ends.shape == (6, 9, 2, 2)
    lengths = ends[:, :, 1, 0] - ends[:, :, 0, 0]
    bars = logged(recordings["context_space"], entities.HISTOGRAM, "BarChart:values")
    shares = np.array([bar[0]["buffer"] for bar in bars])
    assert np.corrcoef(lengths.ravel(), shares.ravel())[0, 1] > 0.99
    assert lengths.max() <= 40
