import pytest
from small_components import with_regression

from silpose.core.errors import InputError
from silpose.regression import Basis, Candidates

VARIETIES = {"one_body": {}, "many_bodies": {"shape": [0, 3]}}
TEST_SCENES = {"shape": [2, 3.5], "elevation": [-5, 30]}


@pytest.fixture(scope="module")
def training_data(run, performers):
    return run(
        "training_data",
        with_regression(performers, basis=Candidates(Basis(width=4))),
        varieties=VARIETIES,
        test_scenes=TEST_SCENES,
        methods=["ridge"],
        frames=[60, 120],
        seeds=[0, 1],
    )


def values(run, **where):
    return [
        row["mean_angular_error_deg"]
        for row in run.rows
        if all(row[name] == value for name, value in where.items())
    ]


def test_every_training_set_is_tested_twice(training_data):
    assert len(training_data.rows) == 2 * 2 * 2 * 2 * 5  # seeds, varieties, frames, tests, methods
    assert len(training_data.metrics) == 2 * 2 * 5


def test_metrics_are_means_over_the_seeds(training_data):
    where = {"training": "many_bodies", "method": "ridge", "frames": 60}
    plain = values(training_data, **where, test="one camera")
    varied = values(training_data, **where, test="varied bodies and cameras")
    assert len(set(plain)) == len(set(varied)) == 2
    metrics = training_data.metrics["ridge, many_bodies, 60"]
    assert metrics["mean_angular_error_deg"] == pytest.approx(sum(plain) / 2)
    assert metrics["varied_scenes_error_deg"] == pytest.approx(sum(varied) / 2)


def test_all_are_tested_on_the_same_unseen_performer(training_data):
    oracle = values(training_data, method="oracle", training="one_body", frames=120, seed=0)
    ridge = values(training_data, method="ridge", training="one_body", frames=120, seed=0)
    assert all(o < r for o, r in zip(oracle, ridge, strict=True))
    assert training_data.result.dataset == "cross_performer/folder"


def test_the_figure_has_a_panel_for_each_test(training_data):
    titles = [axes.get_title("left") for axes in training_data.result.figure.axes]
    assert titles == [
        "unseen performers, one camera",
        "unseen performers, varied bodies and cameras",
    ]


def test_motion_must_be_rendered(run, authors):
    with pytest.raises(InputError, match="training_data renders motion"):
        run("training_data", authors, varieties=VARIETIES, test_scenes=TEST_SCENES)


def test_legends_cover_no_curve(training_data):
    figure = training_data.result.figure
    figure.canvas.draw()
    for axes in figure.axes:
        highest = axes.get_legend().get_window_extent().y1
        lowest = min(min(line.get_ydata()) for line in axes.lines)
        assert axes.transData.transform((1, lowest))[1] > highest
