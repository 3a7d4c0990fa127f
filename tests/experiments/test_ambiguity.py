import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.experiments.ambiguity import SHARE, explained
from silpose.experiments.ambiguity_figure import COLOURS


@pytest.fixture(scope="module")
def ambiguity(run, walkers):
    return run("ambiguity", walkers)


def test_ambiguous_silhouettes_are_counted(ambiguity):
    assert set(ambiguity.metrics) == {"turned", "legs_swapped", "mirrored", "two_modes"}
    two = ambiguity.metrics["two_modes"]
    rows = [row for row in ambiguity.rows if "kind" in row]
    assert two["frames"] == len(rows) / 45
    assert all(row["second_weight"] >= SHARE and row["modes"] >= 2 for row in rows)
    for kind, name in (("turned", "turned"), ("legs swapped", "legs_swapped"), ("other", "other")):
        assert two[name] == pytest.approx(np.mean([row["kind"] == kind for row in rows]))


def test_the_better_of_two_modes_is_no_worse_than_the_first(ambiguity):
    two = ambiguity.metrics["two_modes"]
    assert two["error_of_better"] <= two["error_of_first"]
    assert (two["error_of_better"] < two["error_of_first"]) == (two["second_is_better"] > 0)


def test_the_figure_draws_each_frames_two_probabilities(ambiguity):
    below = ambiguity.result.figure.subfigs[1].axes[0]
    assert len(below.patches) == 2 * 45
    assert len(below.get_legend().get_texts()) == 1 + len(COLOURS)


def test_a_second_explanation_needs_its_share():
    angles = np.zeros((2, 54))
    angles[1, 0] = 180
    facing, away = ANGLES.from_angles(angles)
    poses = np.array([[facing, away, away], [facing, away, away], [facing, facing, facing]])
    shares = np.array([[0.9, 0.05, 0.05], [0.8, 0.1, 0.1], [0.4, 0.3, 0.3]])
    assert explained(ANGLES, shares, poses)["turned"].tolist() == [False, True, False]
