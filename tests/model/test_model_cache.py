from pathlib import Path

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.model import ModelCache, PoseModel
from silpose.regression import RidgeRegressor


@pytest.fixture(scope="module")
def model():
    rng = np.random.default_rng(0)
    x = ANGLES.from_angles(rng.normal(0, 10, (30, 54)))
    return PoseModel(None, RidgeRegressor(damping=1).fit(rng.random((30, 8)), x), ANGLES, 15.0)


def test_a_model_is_kept_in_the_users_cache_folder(model, tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    cache = ModelCache.of("settings")
    assert cache.file.parent == tmp_path / "silpose"
    assert cache.fetch() is None
    assert cache.store(model)
    assert cache.fetch().frames_per_second == 15.0
    assert [file.name for file in cache.file.parent.iterdir()] == [cache.file.name]
    assert ModelCache.of("others").fetch() is None


def test_a_damaged_file_is_as_none_with_a_warning(model, tmp_path):
    cache = ModelCache.of("settings", tmp_path)
    cache.file.write_bytes(b"half of it")
    with pytest.warns(UserWarning, match="is damaged: the model is trained anew"):
        assert cache.fetch() is None
    assert cache.store(model) and cache.fetch() is not None


def test_where_nothing_can_be_written_that_is_said(model, tmp_path):
    (tmp_path / "file").touch()
    with pytest.warns(UserWarning, match="choose another folder, cache=FOLDER"):
        assert not ModelCache.of("settings", tmp_path / "file" / "below").store(model)


def test_a_full_disk_does_not_lose_the_model_that_was_trained(model, tmp_path):
    resource = pytest.importorskip("resource")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, before[1]))
    try:
        with pytest.warns(UserWarning, match=r"cannot keep the model in .* \(File too large\)"):
            assert not ModelCache.of("settings", tmp_path).store(model)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert not list(tmp_path.iterdir())


def test_without_a_home_another_folder_is_asked_for(monkeypatch):
    monkeypatch.setattr("silpose.model.model_cache.user_cache_path", lambda *_, **__: Path("~/a"))
    monkeypatch.setattr("silpose.model.model_cache.expanded", lambda path: path)
    with pytest.raises(InputError, match="choose a folder, cache=FOLDER"):
        ModelCache.of("settings")
