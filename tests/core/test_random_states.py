import numpy as np

from silpose.core.random_states import generator_of, seed_of


def test_an_integer_is_its_own_seed_and_generators_give_one():
    assert seed_of(7) == seed_of(np.int64(7)) == 7
    assert seed_of(None) is None
    for kind in (np.random.RandomState, np.random.default_rng):
        assert seed_of(kind(3)) == seed_of(kind(3)) != seed_of(kind(4))


def test_generators_are_those_of_the_seed():
    given = np.random.default_rng(1)
    assert generator_of(given) is given
    assert generator_of(5).random() == np.random.default_rng(5).random()
