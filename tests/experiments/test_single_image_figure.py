import warnings

from matplotlib.figure import Figure

from silpose.core.pose_space import ANGLES
from silpose.experiments.single_image_figure import _plot_norms


def test_a_take_of_one_frame_is_drawn_without_a_word(sequence):
    axes = Figure().subplots()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        _plot_norms(axes, ANGLES, sequence.x[:1], sequence.x[:1])
    assert axes.get_xlim() == (0, 1)
