import pytest

from silpose.app.config import load
from silpose.app.paper import PaperOptions, run_paper, runner
from silpose.core.errors import InputError
from silpose.recording import Result, RunFolder, write_result

FEW = ("bridges", "feature_selection")


class Runs:
    """Stands for `run_experiment`: writes a run's files, but for experiments that are to fail."""

    def __init__(self):
        self.names, self.failing = [], set()

    def __call__(self, overrides):
        settings = load(overrides)
        self.names.append(settings.experiment)
        if settings.experiment in self.failing:
            raise InputError("out of luck")
        place = settings.recording
        folder = RunFolder.start(
            settings.experiment, runner.OmegaConf.to_yaml(settings, resolve=True), root=place.root,
            name=place.name, sinks=[],
        )  # fmt: skip
        write_result(folder, Result("made up", {"rvm": {"kept": 0.1, "iterations": 9}}), 0, {})


@pytest.fixture
def ran(monkeypatch):
    runs = Runs()
    monkeypatch.setattr(runner, "run_experiment", runs)
    return runs


def paper(tmp_path, **more):
    return run_paper(PaperOptions(parts=FEW, fast=True, root=str(tmp_path), **more), n_jobs=1)


def test_what_is_finished_is_not_done_again_and_a_failure_stops_nothing(tmp_path, ran):
    ran.failing.add("feature_selection")
    report = paper(tmp_path)
    assert report.failed == {"walkers/feature_selection": "out of luck"}
    assert set(report.found["walkers"]) == {"bridges"}
    assert (tmp_path / "fast" / "report.html").is_file()
    ran.failing.clear()
    ran.names.clear()
    assert set(paper(tmp_path).found["walkers"]) == {*FEW}
    assert ran.names == ["feature_selection"]
    ran.names.clear()
    paper(tmp_path, experiment_overrides=("regression.rvm.nu=[20]",))
    assert set(ran.names) == {*FEW}  # other settings


def test_settings_are_looked_at_before_anything_runs(tmp_path, ran):
    with pytest.raises(InputError, match=r"there is no setting 'regression.nu'"):
        paper(tmp_path, experiment_overrides=("regression.nu=3",))
    assert not ran.names


def test_a_setting_of_the_first_part_alone_stops_no_other(tmp_path, ran):
    report = paper(tmp_path, experiment_overrides=("samples=5",))
    assert set(report.found["walkers"]) == {"feature_selection"}
    assert "no setting 'samples'" in report.failed["walkers/bridges"]
