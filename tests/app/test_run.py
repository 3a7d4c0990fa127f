from contextlib import contextmanager

import pytest
import yaml

import silpose
from silpose.app.config import load
from silpose.core.errors import InputError
from silpose.core.parallel import engine
from silpose.recording.runs.claim import claimed


def test_a_run_is_made_from_overrides_or_settings(fast, tmp_path):
    overrides = [*fast, f"recording.root={tmp_path}", "recording=none"]
    overrides += ["methods=[ridge]", "show=ridge"]
    first = silpose.run_experiment([*overrides, "recording.name=a"])
    second = silpose.run_experiment(load([*overrides, "recording.name=b"]))
    assert first.folder == tmp_path / "single_image" / "a"
    assert first.metrics == second.metrics
    assert first.headline == second.headline
    assert {"masks", "descriptors", "regression"} <= set(first.seconds)


def test_the_engine_is_a_setting(fast, tmp_path, monkeypatch):
    engines = []

    @contextmanager
    def watched(*chosen):
        engines.append(chosen)
        with engine(*chosen):
            yield

    monkeypatch.setattr("silpose.app.run.engine", watched)
    overrides = [*fast, f"recording.root={tmp_path}", "recording=none"]
    overrides += ["methods=[ridge]", "show=ridge", "n_jobs=2"]
    found = [
        silpose.run_experiment([*overrides, f"engine={name}", f"recording.name={name}"]).metrics
        for name in ("local", "joblib")
    ]
    assert found[0] == found[1]
    assert engines == [("local", 2, None), ("joblib", 2, None)]


def test_an_engine_that_cannot_be_used_is_refused_before_anything_is_done(tmp_path, monkeypatch):
    monkeypatch.setattr("silpose.core.parallel.find_spec", lambda name: None)
    for override, message in {
        "engine=ray": r"Ray is not installed: pip install 'silpose\[ray\]'",
        "engine=spark": "'engine' must be one of",
        "address=host:6379": "address=host:6379 needs engine='ray'",
    }.items():
        with pytest.raises(InputError, match=message):
            silpose.run_experiment([override, f"recording.root={tmp_path}"])
    assert not list(tmp_path.iterdir())


def test_a_run_keeps_all_its_settings(finished):
    settings = yaml.safe_load(finished.config)
    assert settings["regression"]["svm"]["penalty"] == 3  # as constructed
    assert settings["regression"]["basis"]["width"] == [2]
    assert settings["motion"]["seed"] == settings["seed"] == 0
    assert settings["experiment"] == "single_image"
    assert settings["show"] == "rvm_20"


def test_a_failed_run_leaves_no_folder(fast, tmp_path, monkeypatch):
    def fail(components, **own):
        raise RuntimeError("in the middle")

    monkeypatch.setattr("silpose.experiments.single_image.single_image", fail)
    with pytest.raises(RuntimeError, match="in the middle"):
        silpose.run_experiment([*fast, f"recording.root={tmp_path / 'recordings'}"])
    assert not list((tmp_path / "recordings").iterdir())


def test_a_folder_in_which_another_run_works_is_left_alone(fast, tmp_path):
    pytest.importorskip("fcntl")
    folder = tmp_path / "single_image" / "mine"
    folder.mkdir(parents=True)  # empty until the other run has something to write
    with claimed(folder), pytest.raises(InputError, match="another run is working in"):
        silpose.run_experiment([*fast, f"recording.root={tmp_path}", "recording.name=mine"])
    assert folder.is_dir()


def test_the_public_names_are_there():
    assert dir(silpose) == sorted(silpose.__all__)
    for name in silpose.__all__:
        assert getattr(silpose, name).__doc__
    with pytest.raises(AttributeError):
        silpose.nothing  # noqa: B018


@pytest.mark.parametrize("override", ["sweep=seeds", "-m", "seed=1,2", "hydra/launcher=joblib"])
def test_a_sweep_from_python_is_refused_with_the_command_that_makes_it(override, tmp_path):
    with pytest.raises(InputError, match="silpose -m"):
        silpose.run_experiment([override, f"recording.root={tmp_path}"])
    assert not list(tmp_path.iterdir())
