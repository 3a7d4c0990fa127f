import numpy as np

from silpose.experiments.masks_figure import masks_figure
from silpose.recording import palette
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


def test_the_legend_names_the_colours_that_are_drawn_and_no_others():
    person = np.zeros((8, 6), np.uint8)
    person[2:6, 2:4] = 1
    with_hole, with_speck = person.copy(), person.copy()
    with_hole[3, 3], with_speck[0, 0] = 0, 1
    said = {"Grey": [], "Amber": []}
    for mask in (person, with_hole, with_speck):
        figure = masks_figure(MaskSequence([mask], ["0"], "it", "grey"), [person], None, 4)
        for colour in said:
            said[colour].append(colour in figure.get_supxlabel())
    assert said == {"Grey": [False, False, True], "Amber": [False, True, False]}
    filled = masks_figure(MaskSequence([with_hole], ["0"], "it", "grey"), [person], None, 4)
    colour = filled.axes[0].images[0].get_array()[3, 3]
    assert palette.NAMES[tuple(np.round(255 * colour).astype(int))] == "amber"
