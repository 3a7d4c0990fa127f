import numpy as np

from silpose.silhouette.box import Box


def test_it_holds_the_foreground_and_nothing_else():
    mask = np.zeros((30, 40), np.uint8)
    mask[5:20, 10:14] = 1
    box = Box.of(mask)
    assert (box.top, box.bottom, box.left, box.right) == (5, 20, 10, 14)
    assert (box.height, box.width) == (15, 4)
