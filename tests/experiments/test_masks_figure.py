import numpy as np

from silpose.experiments.masks_figure import masks_figure
from silpose.silhouette import MaskSequence


def test_masks_are_drawn_evenly_and_what_is_left_out_is_marked():
    masks = [np.zeros((8, 6), np.uint8) for _ in range(30)]
    kept = [mask.copy() for mask in masks]
    for mask in masks:
        mask[2:6, 2:4], mask[0, 0] = 1, 1
    for mask in kept:
        mask[2:6, 2:4] = 1
    names = [f"{frame}.png" for frame in range(30)]
    figure = masks_figure(MaskSequence(masks, names, "it", "grey values"), kept, None, 4)
    drawn = [axes for axes in figure.axes if axes.images]
    assert [axes.get_title() for axes in drawn] == ["0.png", "10.png", "19.png", "29.png"]
    picture = drawn[0].images[0].get_array()
    assert len({tuple(picture[row, column]) for row, column in ((0, 0), (3, 3), (7, 5))}) == 3
