from dataclasses import replace
from functools import partial

import cv2
import numpy as np
import pandas
import pytest
from walk_film import film_walk, walk_model

from silpose.core.errors import InputError
from silpose.experiments import EXPERIMENTS
from silpose.fitting import FittingOptions
from silpose.recording import RunFolder
from silpose.silhouette.masks import MaskSource
from silpose.silhouette.video import VideoMasks


@pytest.fixture(scope="module")
def film(tmp_path_factory, body):
    return film_walk(tmp_path_factory.mktemp("film") / "walk.mp4", body).file


@pytest.fixture(scope="module")
def model(tmp_path_factory, body):
    """The folder of a small model."""
    folder = tmp_path_factory.mktemp("model")
    walk_model(body).save(folder / "model.npz")
    return str(folder)


@pytest.fixture(scope="module")
def components(walkers, film):
    fitting = FittingOptions(enabled=True, camera="estimated")
    return replace(walkers, masks=MaskSource(str(film)), fitting=fitting)


@pytest.fixture(scope="module")
def fitted(run, components, model):
    return run("video", components, model=model)


def test_a_film_leaves_track_gait_and_recording(fitted):
    names = {file.name for file in fitted.folder.iterdir()}
    tracks = {f"track.{kind}" for kind in ("csv", "npz", "bvh", "trc")}
    assert names >= {*tracks, "gait.csv", "gait.html", "video.png", "run.rrd", "results.csv"}
    table = pandas.read_csv(fitted.folder / "track.csv")
    assert len(table) == 22 and set(table["state"]) <= {"fitted", "poor", "blank"}
    assert np.nanmedian(table["iou"]) > 0.7
    assert "overlap 0." in fitted.result.summary and "model '" in fitted.result.summary
    assert list(fitted.seconds)[:3] == ["masks", "fitting", "figure"]
    assert fitted.result.model is None


def test_live_a_camera_leaves_the_same(run, components, model, fitted, tmp_path):
    folder = RunFolder.start("video", root=str(tmp_path))
    live = replace(components, video=partial(VideoMasks, real_time=True), run=folder)
    followed = run("video", live, model=model, record=False)
    assert (folder.folder / "run.rrd").stat().st_size > 10_000
    table = pandas.read_csv(followed.folder / "track.csv")
    assert len(table) >= 2
    assert set(table["state"]) <= {"starting", "tracking", "lost", "recovered"}
    assert (followed.folder / "gait.html").is_file()


def test_masks_alone_are_kept_if_so_wanted(run, components, model, fitted, tmp_path):
    folder = RunFolder.start("video", root=str(tmp_path), keep_pictures=False)
    private = run("video", replace(components, run=folder), model=model, record=False)
    shown, hidden = (
        cv2.imread(str(own.folder / "video.png")).reshape(-1, 3) for own in (fitted, private)
    )
    assert (shown[:, 2].astype(int) - shown[:, 1] > 100).mean() > 0.01  # the red figure
    assert (hidden[:, 2].astype(int) - hidden[:, 1] > 100).mean() < 0.5 * (
        shown[:, 2].astype(int) - shown[:, 1] > 100
    ).mean()


def test_what_cannot_be_fitted_is_refused_before_a_training(components, film):
    for wrong, message in (
        ({"masks": MaskSource()}, r"no film: add silhouette=video"),
        ({"masks": MaskSource(str(film), body_height=175)}, r"body_height must be from 0\.5"),
        ({"fitting": FittingOptions()}, r"leave out fitting\.enabled=false"),
    ):
        with pytest.raises(InputError, match=message):
            EXPERIMENTS["video"](replace(components, **wrong))
    with pytest.raises(InputError, match=r"there is no model 'missing'"):
        EXPERIMENTS["video"](components, model="missing")
