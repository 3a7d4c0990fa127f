import pytest
from small_components import LINEAR, with_regression

from silpose.core.errors import InputError


@pytest.fixture(scope="module")
def selection(run, walkers):
    linear = with_regression(walkers, basis=LINEAR)
    return run("feature_selection", linear, method="rvm_10", samples=5)


def test_the_points_of_the_retained_bins_are_marked(selection):
    for part, values in selection.metrics.items():
        bins = [row["bin"] for row in selection.rows if row["part"] == part]
        assert values["functions_kept"] == 4 == len(set(bins))
        assert 0 < values["points_share"] < 0.6


def test_the_figure_has_a_row_for_each_part_and_a_column_for_each_sample(selection):
    axes = selection.result.figure.axes
    assert len(axes) == 5 * len(selection.metrics)
    assert [a.get_ylabel() for a in axes[::5]] == [
        part.replace("_", " ") for part in selection.metrics
    ]


def test_bins_and_masks_are_needed(run, walkers, authors):
    with pytest.raises(InputError, match="add regression=linear"):
        run("feature_selection", walkers)
    with pytest.raises(InputError, match="feature_selection needs masks"):
        run("feature_selection", with_regression(authors, basis=LINEAR), record=False)
