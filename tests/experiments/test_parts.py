import numpy as np
import pytest
from small_components import LINEAR, with_regression

from silpose.regression import Candidates, RelevanceVectorRegressor


@pytest.fixture(scope="module")
def parts(run, walkers):
    rvm = Candidates(RelevanceVectorRegressor(), {"nu": [2, 8, 32]})
    return run("parts", with_regression(walkers, basis=LINEAR, rvm=rvm, slack=0.0))


def test_a_sparsity_is_chosen_for_each_part(parts):
    names = ["body", "torso", "left_arm", "right_arm", "left_leg", "right_leg"]
    assert list(parts.metrics) == names
    for part, values in parts.metrics.items():
        own = [row for row in parts.rows if row["part"] == part]
        best = min(own, key=lambda row: row["validation_error"])
        assert best["nu"] == values["nu"]
        assert best["kept"] == pytest.approx(values["functions_kept"] / 40)


def test_kept_falls_with_nu(parts):
    for part in parts.metrics:
        own = [row for row in parts.rows if row["part"] == part]
        kept = [row["kept"] for row in sorted(own, key=lambda row: row["nu"])]
        assert kept == sorted(kept, reverse=True) and kept[-1] < kept[0]


def test_regressors_beat_the_mean_pose(parts):
    errors, means = parts.values("part_error"), parts.values("mean_pose_error")
    assert errors["body"] < means["body"]
    assert np.mean([errors[p] < means[p] for p in errors]) > 0.5


def test_the_figure_draws_a_curve_for_each_part(parts):
    errors, kept = parts.result.figure.axes
    labels = [line.get_label().partition(":")[0] for line in errors.lines[::2]]
    assert labels == [part.replace("_", " ") for part in parts.metrics]
    assert len(kept.lines) == len(errors.lines) == 2 * 6  # each with the dot of what was chosen
