"""A film of a person who walks by."""

import numpy as np
import pytest
from video_films import figure, noisy, paint, wall, write_film


@pytest.fixture(scope="session")
def truth(sequence):
    """Masks of 32 frames, the person walking through."""
    return [figure(sequence.masks, frame) for frame in range(32)]


@pytest.fixture(scope="session")
def pictures(truth):
    rng = np.random.default_rng(1)
    return [noisy(paint(wall(), mask), rng) for mask in truth]


@pytest.fixture(scope="session")
def film(tmp_path_factory, pictures):
    return write_film(tmp_path_factory.mktemp("film") / "walk.mp4", pictures)
