import pytest
from small_components import with_regression

from silpose.core.errors import InputError
from silpose.experiments.training_data import _figure
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


def test_the_figure_draws_all_methods_and_training_data_and_tells_them_apart():
    methods, varieties = [f"method_{k}" for k in range(5)], [f"data_{k}" for k in range(5)]
    rows = [
        {"training": v, "frames": n, "method": m, "test": test, "mean_angular_error_deg": 5.0}
        for test in ("one camera", "varied bodies and cameras")
        for v in varieties
        for m in (*methods, "oracle")
        for n in (60, 120)
    ]
    figure = _figure(rows, methods)
    for axes in figure.axes:
        curves = [line for line in axes.lines if line.get_marker() != "_"]
        looks = {(c.get_color(), c.get_linestyle(), c.get_marker()) for c in curves}
        assert len(curves) == len(looks) == 5 * 6
    named = [text.get_text() for text in figure.axes[1].get_legend().texts]
    assert named == [*(m.replace("_", " ") for m in methods), "nearest true pose (oracle)"]


def test_the_recording_shows_one_take(training_data):
    record = training_data.result.recording.write
    lengths = {len(errors) for errors in record.keywords["series"].values()}
    assert lengths == {45}


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
