import numpy as np

from silpose.experiments.fitting_robustness_figure import fitting_robustness_figure


def test_each_mask_says_what_it_suffers_from_and_no_bar_loses_less_than_nothing():
    mask = np.zeros((20, 10), np.uint8)
    mask[4:16, 3:7] = 1
    lost = {method: {"holes": -0.001, "frame_cut": 0.2} for method in ("ridge", "fitted_take")}
    shown = {kind: (mask, mask) for kind in ("holes", "frame_cut")}
    figure = fitting_robustness_figure(lost, shown, 0.2)
    bars, *bodies = figure.axes
    assert [axes.get_title() for axes in bodies] == ["holes", "frame cut"]
    assert "-0" not in {text.get_text() for text in bars.texts}


def test_bodies_are_drawn_to_one_scale_at_one_height():
    one, other = np.zeros((2, 20, 10), np.uint8)
    one[4:16, 3:7] = 1
    other[10:18, 1:3] = 1
    figure = fitting_robustness_figure(
        {"ridge": {"holes": 0.1, "shadow": 0.2}},
        {"holes": (one, one), "shadow": (other, other)},
        0.2,
    )
    _, *bodies = figure.axes
    assert len({axes.get_ylim() for axes in bodies}) == 1
