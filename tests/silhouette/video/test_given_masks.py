import cv2
import numpy as np
import pytest
from video_films import overlap, write_film

from silpose.silhouette.video import VideoMasks
from silpose.silhouette.video.given_masks import given_masks


def write(folder, pictures, suffix="png"):
    for k, picture in enumerate(pictures):
        cv2.imwrite(str(folder / f"{k}.{suffix}"), picture)
    return folder


@pytest.mark.parametrize(
    ("suffix", "person", "around"),
    [("png", 255, 0), ("png", 1, 0), ("png", 0, 255), ("jpg", 255, 0)],
)
def test_a_person_in_one_place_is_seen_in_masks_of_any_segmenter(
    tmp_path, truth, suffix, person, around
):
    still = [np.where(truth[9] > 0, person, around).astype(np.uint8)] * 6
    folder = write(tmp_path, still, suffix)
    with pytest.warns(UserWarning, match="are masks already"):
        frames = list(VideoMasks(folder, frames_per_second=30))
    assert {frame.state for frame in frames} == {"person"}
    assert min(overlap(frame.mask, truth[9]) for frame in frames) > (0.99, 0.95)[suffix == "jpg"]


def test_a_film_of_masks_is_taken_as_it_is(tmp_path, truth):
    pictures = [np.repeat(255 * mask[..., None], 3, axis=2) for mask in truth]
    film = write_film(tmp_path / "masks.mp4", pictures)
    with pytest.warns(UserWarning, match="are masks already"):
        frames = list(VideoMasks(film))
    assert np.median([overlap(frame.mask, truth[frame.index]) for frame in frames]) > 0.97


def test_a_chosen_background_is_used_all_the_same(tmp_path, truth):
    folder = write(tmp_path, [255 * truth[9]] * 6)
    with pytest.warns(UserWarning, match="grey"):
        frames = list(VideoMasks(folder, frames_per_second=30, background="median"))
    assert not any(frame.seen for frame in frames)


def test_pictures_of_a_scene_are_no_masks(pictures):
    grey = [np.repeat(picture[:, :, 1:2], 3, axis=2) for picture in pictures]
    empty = [np.zeros((30, 40, 3), np.uint8)] * 4
    assert all(given_masks(some) is None for some in (pictures, grey, empty, []))
