import numpy as np
import pytest

from silpose.core.errors import InputError


@pytest.fixture(scope="module")
def space(run, walkers):
    return run("descriptor_space", walkers, contexts=500)


def test_every_centre_is_in_the_plane(space):
    assert [row["centre"] for row in space.rows] == list(range(40))
    places = np.array([[row["component_1"], row["component_2"]] for row in space.rows])
    assert np.isfinite(places).all() and len(np.unique(places, axis=0)) == 40


def test_principal_components_hold_much_of_the_variance(space):
    values = space.metrics["codebook"]
    assert 2 / 60 < values["variance_in_plane"] < 1  # more than two of 60 equal ones
    assert 8 <= values["centres_voted_for"] <= 40  # each context votes into 8


def test_no_more_contexts_than_asked_for_are_drawn(space):
    everything = space.result.figure.axes[2]
    assert len(everything.lines[0].get_xdata()) == 500
    assert len(everything.collections[0].get_offsets()) == 40


def test_a_plane_needs_two_contexts(run, walkers):
    with pytest.raises(InputError, match="contexts must be at least 2"):
        run("descriptor_space", walkers, contexts=1)
