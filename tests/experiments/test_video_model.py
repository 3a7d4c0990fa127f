from dataclasses import replace

import pytest
from small_components import components_of
from walk_film import walk_model

from silpose.core.errors import InputError
from silpose.dataset import SamePerformer
from silpose.experiments.video_model import video_model
from silpose.fitting import FittingOptions
from silpose.model import ModelCache
from silpose.motion import WalkerTakes


@pytest.fixture(scope="module")
def components():
    fitting = FittingOptions(True, "estimated", "estimated", iterations=2, starts=1)
    walkers = WalkerTakes(seconds=2, test_seconds=2)
    return components_of(SamePerformer(), walkers, fitting=fitting, trained_by=lambda: "small")


@pytest.mark.slow
def test_a_model_is_trained_once(components, tmp_path):
    first = video_model(components, None, str(tmp_path))
    assert "model trained, and kept in" in first.origin and first.unkept is None
    assert first.model.fitter.fitter.camera_is == "estimated" and first.model.tracker is not None
    again = video_model(components, None, str(tmp_path))
    assert "model found in" in again.origin
    assert ModelCache.of("other", tmp_path).fetch() is None


def test_a_model_that_is_given_is_used(components, tmp_path, body):
    model = walk_model(body)
    model.save(tmp_path / "model.npz")
    found = video_model(components, str(tmp_path), None)
    assert found.given == str(tmp_path) and found.unkept is None
    assert model.fitter.fitter.shape_is == "known"
    assert found.model.fitter.fitter.shape_is == "estimated"  # as of a film
    replace(model, fitter=None).save(tmp_path / "model.npz")
    with pytest.raises(InputError, match=r"has no fitter.*leave out model="):
        video_model(components, str(tmp_path), None)
