import pytest

from silpose.core.errors import InputError


@pytest.fixture(scope="module")
def choices(run, walkers):
    varied = {"codebook_size": [20, 40], "voters": [None, 8], "hellinger": [True, False]}
    return run("descriptor_choices", walkers, choices={**varied, "radius": []}, seeds=[0, 1])


def test_parameters_are_varied_one_at_a_time(choices):
    names = {"usual", "mean_pose", "codebook_size=20", "voters=all", "hellinger=False"}
    assert set(choices.metrics) == names
    assert [row["seed"] for row in choices.rows] == 4 * [0, 1]


def test_errors_are_means_over_the_codebooks(choices):
    usual = [row["test_error"] for row in choices.rows if row["choice"] == "usual"]
    assert len(set(usual)) == 2
    assert choices.metrics["usual"]["test_error"] == pytest.approx(sum(usual) / 2)
    assert choices.metrics["usual"]["test_error"] < choices.metrics["mean_pose"]["test_error"]


def test_the_headline_is_the_best_validation_error(choices):
    assert choices.result.headline == min(choices.values("validation_error").values())


def test_the_figure_has_a_panel_for_each_parameter(choices):
    panels = [axes for axes in choices.result.figure.axes if axes.get_title("left")]
    assert [axes.get_title("left") for axes in panels] == ["codebook size", "voters", "hellinger"]
    assert [tick.get_text() for tick in panels[1].get_xticklabels()] == ["all", "8"]


def test_unknown_parameters_and_nothing_at_all_are_refused(run, walkers):
    with pytest.raises(InputError, match="the descriptor has no 'radii'"):
        run("descriptor_choices", walkers, choices={"radii": [3]})
    with pytest.raises(InputError, match="nothing to vary"):
        run("descriptor_choices", walkers, choices={"radius": []})
