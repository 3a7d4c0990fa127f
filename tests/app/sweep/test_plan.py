from pathlib import Path

import pytest

from silpose.app.sweep.plan import plan_sweep
from silpose.core.errors import InputError


def test_paths_are_absolute_before_jobs_are_sent(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MOCAP", "captured")
    plan = plan_sweep(["motion=bvh", "motion.root=${oc.env:MOCAP}", "seed=1,2"])
    assert f"motion.root='{tmp_path / 'captured'}'" in plan.overrides
    assert f"recording.root='{tmp_path / 'recordings'}'" in plan.overrides
    assert plan.folders == (tmp_path / "recordings/single_image" / plan.name,)
    assert plan.runs == 2


def test_a_sweep_is_named_by_what_changes_its_results():
    def name(*overrides):
        return plan_sweep(overrides).name

    usual = name("seed=1,2")
    assert usual.startswith("seed-")
    assert usual == name("n_jobs=2", "seed=1,2", "recording.root=elsewhere")
    others = {name("seed=1,3"), name("seed=1,2", "regression.slack=0.3"), name("sweep=seeds")}
    assert len({usual, *others}) == 4


def test_values_of_a_named_sweep_can_be_replaced():
    assert plan_sweep(["sweep=seeds"]).runs == 10
    plan = plan_sweep(["sweep=seeds", "seed=1,2"])
    assert plan.runs == 2
    assert plan.varied == ("seed",)


def test_runs_of_another_version_are_doubted(tmp_path):
    plan = plan_sweep(["seed=1,2", f"recording.root={tmp_path}"])
    assert plan.prepare() == []
    assert plan.prepare() == []
    file = plan.folders[0] / "sweep.yaml"
    file.write_text(file.read_text().replace("python: ", "python: 2"))
    (doubt,) = plan.prepare()
    assert "made by another version" in doubt
    file.write_text("nonsense")
    with pytest.raises(InputError, match="was not written by a sweep"):
        plan.prepare()


def test_a_folder_that_cannot_be_written_to_is_named(read_only):
    plan = plan_sweep(["seed=1,2", f"recording.root={Path(read_only)}"])
    with pytest.raises(InputError, match=r"cannot write to .*choose another recording\.root"):
        plan.prepare()
