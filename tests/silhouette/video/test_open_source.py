import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.video import open_source
from silpose.silhouette.video.film_frames import FilmFrames
from silpose.silhouette.video.folder_frames import FolderFrames


def test_a_film_and_a_folder_are_told_apart(film, tmp_path, pictures):
    cv2.imwrite(str(tmp_path / "1.png"), pictures[0])
    assert isinstance(open_source(film), FilmFrames)
    assert isinstance(open_source(str(film)), FilmFrames)
    assert isinstance(open_source(film.as_uri()), FilmFrames)
    assert isinstance(open_source(tmp_path, rate=25), FolderFrames)


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ("nowhere.mp4", "there is no file 'nowhere.mp4'"),
        ("", "empty name"),
        ("98", "no camera 98"),
        (98, "no camera 98"),
        (np.int64(98), "no camera 98"),
        ("-1", "no camera -1"),
        ("bad://nowhere", "no stream at"),
        (None, "no source of pictures"),
        (True, "no source of pictures"),
        (1.5, "no source of pictures"),
        ("a.png", "is one picture"),
        ("a.apng", "an animation, and no video: convert it"),
        ("a.webp", "an animation, and no video: convert it"),
    ],
)
def test_what_is_no_source_is_refused(source, words):
    with pytest.raises(InputError, match=words):
        open_source(source)
