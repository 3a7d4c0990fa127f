"""A film of a walk, a small model, and both together."""

import pytest
from walk_film import film_walk, walk_model

from silpose.model.video import FilmMasks, Placement, fit_film
from silpose.silhouette.video import VideoMasks


@pytest.fixture(scope="session")
def walk(tmp_path_factory, body):
    """The film of a walk, and the truth."""
    return film_walk(tmp_path_factory.mktemp("film") / "walk.mp4", body)


@pytest.fixture(scope="session")
def model(body):
    return walk_model(body)


@pytest.fixture(scope="session")
def film(walk):
    return FilmMasks.read(VideoMasks(walk.file))


@pytest.fixture(scope="session")
def fitted(model, film):
    """The film, fitted."""
    return fit_film(model, film, Placement.of(model, film.shape))
