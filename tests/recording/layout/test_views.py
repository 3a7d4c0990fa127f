import numpy as np
import pytest

from silpose.recording import Header
from silpose.recording import entity_paths as entities
from silpose.recording.layout.views import blueprint, errors_view, figure_view, span_of, texts_view
from silpose.recording.stream import recording_stream


@pytest.mark.parametrize(("settings", "visible"), [("seed: 0\n", None), ("", False)])
def test_settings_and_figures_that_are_missing_take_no_space(tmp_path, settings, visible):
    texts, figure = texts_view(), figure_view()
    header = Header("study", "notebook", tmp_path / "run.rrd", "in words", settings)
    with recording_stream(header, blueprint([texts, figure], [1, 1], 15.0)):
        pass
    views = {view.origin: view.visible for view in texts.contents}
    assert views == {entities.METRICS: None, entities.SETTINGS: visible}
    assert figure.visible is False


def test_influential_examples_stand_below_results_with_settings_behind_these():
    texts, examples = texts_view(examples=True).contents
    assert examples.origin == entities.INFLUENTIAL_EXAMPLES
    assert examples.name.startswith("why this pose?")  # as notebooks call it
    assert [view.origin for view in texts.contents] == [entities.METRICS, entities.SETTINGS]
    assert texts.active_tab == 0


def test_titles_say_which_colour_is_what():
    title = errors_view("mean_angular_error_deg", {}, ["rvm", "nearest"], "rvm").name
    words = "relevance vectors (vermilion), nearest neighbour (green)"
    assert title == f"mean angular error, degrees: {words}"


@pytest.mark.parametrize(
    ("highest", "top"),
    [(0.04, 0.1), (0.8, 1), (2.5, 3), (9.0, 10), (12.0, 20), (31.0, 40), (0.0, 1)],
)
def test_axes_of_errors_begin_at_0_and_have_a_tick_above_all(highest, top):
    errors = [np.array([np.nan, highest / 2, highest]), np.array([np.nan])]
    low, high = span_of(errors)
    assert low == 0
    assert top <= high < 1.1 * top
