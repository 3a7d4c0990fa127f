import pytest

from silpose.core.errors import InputError
from silpose.experiments.setup import prepare_tracking


@pytest.fixture(scope="module")
def widths(run, walkers):
    return run("kernel_widths", walkers, factors=[0.5, 1])


def test_every_pair_of_factors_has_an_error(widths):
    rows = [row for row in widths.rows if "error" in row]
    assert len(rows) == 2 * 2 * 2
    for method, values in widths.metrics.items():
        own = [row["error"] for row in rows if row["method"] == method]
        assert min(own) == values["error"] < values["widest_error"] == max(own)


def test_with_factors_of_1_it_is_the_tracker_as_chosen(widths, walkers):
    training = prepare_tracking(walkers)
    tracks = training.follow(
        {
            "state_sensitive": lambda z, start: training.state_sensitive.track(z, start).x,
            "tracker": lambda z, _: training.tracker.track(z).x,
        }
    )
    for method, metrics in training.measure(tracks).items():
        same = [
            row["error"]
            for row in widths.rows
            if (row["method"], row.get("beta_x_factor"), row.get("beta_z_factor")) == (method, 1, 1)
        ]
        assert same == pytest.approx([metrics["mean_angular_error_deg"]] * (method in tracks))


def test_factors_must_be_positive(run, walkers):
    with pytest.raises(InputError, match="factors must be positive, not -1"):
        run("kernel_widths", walkers, factors=[-1, 1])
    with pytest.raises(InputError, match="factors must be at least one value"):
        run("kernel_widths", walkers, factors=[])
