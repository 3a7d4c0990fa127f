import numpy as np
from video_films import wall

from silpose.silhouette.video.median import median_picture


def test_the_median_is_the_scene_without_the_person(pictures):
    median, deviation = median_picture(pictures)
    assert np.abs(median - wall()).mean() < 2
    assert np.percentile(deviation, 95) < 6


def test_it_is_numpys_of_odd_many():
    rng = np.random.default_rng(0)
    pictures = rng.integers(0, 255, (7, 50, 9, 3), np.uint8)
    median, deviation = median_picture(pictures)
    assert (median == np.median(pictures, axis=0)).all()
    off = np.abs(pictures.astype(int) - median)
    assert (deviation == np.median(off, axis=0).max(axis=-1)).all()
