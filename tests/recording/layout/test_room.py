import numpy as np
import pytest
import rerun.blueprint as rrb

from silpose.recording import entity_paths
from silpose.recording.header import ROOM
from silpose.recording.layout import (
    comparison_layout,
    fitting_layout,
    hypotheses_layout,
    modes_layout,
    room_for_results,
    single_image_layout,
    study_layout,
    tracking_layout,
)

WINDOW, METRIC, ERRORS = (0.0, 1.0, 0.0, 1.0), "mean_angular_error_deg", {"ridge": np.ones(3)}
LAYOUTS = {
    "single_image": single_image_layout(["ridge"], 15.0, METRIC, ERRORS, WINDOW, examples=True),
    "training_data": study_layout("error", 15.0),
    "tracking": tracking_layout(["ridge"], 15.0, METRIC, ERRORS, True, WINDOW),
    "mixture": modes_layout(4, 15.0, METRIC, ERRORS, True, WINDOW),
    "hypotheses": hypotheses_layout(4, 15.0, True, WINDOW),
    "fitting": fitting_layout(["ridge"], 15.0, METRIC, ERRORS, WINDOW),
    "compare": comparison_layout({"001": "ridge"}, 15.0, False),
}


def test_a_pane_has_its_share_of_a_small_window():
    text = rrb.TextDocumentView(origin=entity_paths.METRICS)
    beside = rrb.Horizontal(rrb.Spatial2DView(), rrb.Vertical(rrb.Tabs(text)), column_shares=[3, 1])
    assert room_for_results(rrb.Blueprint(beside)) == int((256 - 40) / 6.5)
    grid = rrb.Grid(rrb.Spatial2DView(), text, grid_columns=2)
    assert room_for_results(rrb.Blueprint(grid)) == int((512 - 40) / 6.5)
    assert room_for_results(rrb.Blueprint(rrb.Spatial2DView())) == 0


@pytest.mark.parametrize("kind", LAYOUTS)
def test_results_have_room_for_two_errors_in_a_small_window(kind):
    assert room_for_results(LAYOUTS[kind]) >= ROOM


@pytest.mark.parametrize(
    ("kind", "names"),
    [
        ("hypotheses", ("tracker_given_start", "angles", "joints", "heading")),
        ("training_data", ("mean_pose, bodies_and_cameras, 40000", "angles", "varied")),
        ("tracking", ("nearest_smoothed", "angles", "joints")),
        ("fitting", ("fitted_from_hypotheses", "angles", "joints")),
        ("single_image", ("mean_pose", "angles", "joints", "heading")),
    ],
)
def test_what_matters_is_in_the_first_table(kind, names):
    assert room_for_results(LAYOUTS[kind]) >= len(names[0]) + sum(len(n) + 2 for n in names[1:])
