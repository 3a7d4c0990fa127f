from pathlib import Path

from silpose.silhouette.masks.film_headers import cut_off


def test_films_of_uneven_rate_are_not_cut_off():
    film = Path("film.mp4")
    assert "ends after 60 of 88 frames" in cut_off(film, 60, 88, 59)
    assert not cut_off(film, 60, 88, 87)
    assert not cut_off(film, 80, 88, 0)
