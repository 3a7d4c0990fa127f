import numpy as np
import pytest
from video_films import noisy, overlap, wall, write_film

from silpose.core.errors import InputError
from silpose.model.video import FilmMasks
from silpose.silhouette.video import VideoMasks


def test_masks_of_a_film_are_kept_packed(film, walk):
    assert len(film) == len(walk.masks) == 22
    assert film.frames_per_second == pytest.approx(25)
    found = [overlap(film.mask(k), walk.masks[k]) for k in range(2, 18)]
    assert np.median(found) > 0.8
    assert sum(mask.bits.nbytes for mask in film.packed) < 22 * 192 * 144 / 40
    assert film.states[0] != "person" and film.states[9] == "person"


def test_a_film_is_divided_where_nobody_is_seen(film):
    (stretch,) = film.stretches()
    assert film.facts.seen[stretch].all() or film.facts.seen[stretch].sum() > 15
    film.time[10:] += 5.0  # somebody comes back
    try:
        first, second = film.stretches()
    finally:
        film.time[10:] -= 5.0
    assert first.stop == 10 == second.start


def test_a_film_of_nobody_is_refused_with_what_to_try(tmp_path):
    rng = np.random.default_rng(0)
    empty = write_film(tmp_path / "empty.mp4", [noisy(wall(), rng) for _ in range(12)])
    with pytest.raises(InputError, match=r"0 of 12 frames.*silhouette\.video\.threshold=8"):
        FilmMasks.read(VideoMasks(empty))
