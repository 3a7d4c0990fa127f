import pytest

from silpose.core.errors import InputError
from silpose.evaluation import BASELINES


@pytest.fixture(scope="module")
def robustness(run, walkers):
    own = {"kinds": ["frame_cut", "holes"], "strengths": [0.2, 0.8], "every": 9}
    return run("descriptor_robustness", walkers, **own)


def test_descriptors_stand_beside_their_alternatives(robustness):
    names = ["shape_contexts", "aligned_mask_pca", "hu_moments"]
    names += [f"{name}_trained_on_degraded" for name in names]
    assert set(robustness.metrics) == {*BASELINES, *names}
    assert len(robustness.rows) == 6 * 2 * 2
    error = robustness.values("whole_error")
    assert error["hu_moments"] < error["mean_pose"]


def test_the_gain_lost_is_the_mean_over_the_kinds(robustness):
    for values in robustness.metrics.values():
        if "gain_lost" in values:
            kinds = values["gain_lost_frame_cut"], values["gain_lost_holes"]
            assert values["gain_lost"] == pytest.approx(sum(kinds) / 2)


def test_stronger_damage_makes_worse_errors(robustness):
    weak, strong = (
        row
        for row in robustness.rows
        if (row["descriptor"], row["kind"]) == ("shape_contexts", "frame_cut")
    )
    assert 0 < weak["damage"] < strong["damage"] < 1
    clean = robustness.metrics["shape_contexts"]["whole_error"]
    assert clean < weak["error"] < strong["error"]


def test_the_figure_has_a_panel_for_each_kind_and_a_curve_for_each_descriptor(robustness):
    titles = [axes.get_title("left") for axes in robustness.result.figure.axes[:2]]
    assert titles == ["frame cut", "holes"]
    assert len(robustness.result.figure.axes[0].lines) == 6 + 2  # mean pose, damage


def test_known_kinds_and_rendered_motion_are_needed(run, walkers, authors):
    with pytest.raises(InputError, match="no degradation 'hole'"):
        run("descriptor_robustness", walkers, kinds=["hole"])
    with pytest.raises(InputError, match="damage between 0 and 1"):
        run("descriptor_robustness", walkers, damage=1.0)
    with pytest.raises(InputError, match="descriptor_robustness renders motion"):
        run("descriptor_robustness", authors)
