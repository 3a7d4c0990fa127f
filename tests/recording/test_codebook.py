import numpy as np

from silpose.recording import codebook_picture, palette


def test_a_centre_is_bright_where_its_contour_lies():
    codebook = np.zeros((5, 60))
    codebook[0, 4 * 12] = 1  # the outermost ring, to the right
    codebook[1, 4 * 12 + 3] = 1  # and below
    picture = codebook_picture(codebook, 12).astype(int).sum(axis=-1)
    assert picture.shape == (80, 120)  # 3 in a row
    right, below = picture[:40, :40], picture[:40, 40:80]
    assert right[20, 35] == right.max() > 3 * right[20, 5]
    assert below[35, 20] == below.max() > 3 * below[5, 20]
    assert picture[60, 100] == sum(palette.BACKGROUND)  # no sixth centre: black


def test_neighbours_have_neighbouring_colours():
    colours = np.array([palette.hue(k, 100) for k in range(100)])
    steps = np.abs(np.diff(np.vstack([colours, colours[:1]]), axis=0)).max(axis=1)
    assert steps.max() < 20
