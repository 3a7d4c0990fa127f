import csv
from pathlib import Path

import pytest

from silpose.recording import runs_table


def folder_of(name):
    (found,) = Path("recordings").glob(f"[!.]*/{name}-*")
    return found


def test_a_sweep_has_its_folder_with_a_table_and_a_figure(sweep):
    status, out = sweep("-m", "seed=1,2", "regression.slack=0.1,0.2")
    assert status == 0
    folder = folder_of("seed-slack")
    assert {f.name for f in folder.iterdir() if f.name[0] != "."} == {
        *("seed_1-slack_0.1", "seed_1-slack_0.2", "seed_2-slack_0.1", "seed_2-slack_0.2"),
        *("sweep.yaml", "sweep.csv", "sweep.png"),
    }
    with (folder / "sweep.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [(r["seed"], r["regression.slack"], r["headline"]) for r in rows] == [
        *(("1", "0.1", "1.1"), ("1", "0.2", "1.2"), ("2", "0.1", "2.1"), ("2", "0.2", "2.2")),
    ]
    assert f"silpose compare {folder}/seed_1-slack_0.1" not in out  # which were not recorded
    assert "mean ± standard deviation over 2 seeds; regression.slack=0.1" in out
    assert "1.60 ± 0.71°" in out
    table = runs_table("recordings")
    assert table.loc[("single_image", f"{folder.name}/seed_2-slack_0.1"), "seed"] == 2
    assert len(runs_table(folder)) == len(table) == 4


def test_the_same_command_repeats_nothing(sweep, ran):
    assert sweep("-m", "seed=1,2")[0] == 0
    assert sweep("seed=1,2", "-m", "n_jobs=1", "dataset.cache=null")[0] == 0  # the same results
    assert ran == [1, 2]


def test_a_named_sweep_may_grow_but_not_change(sweep, ran):
    assert sweep("-m", "seed=range(1,2)", "recording.sweep=mine")[0] == 0
    assert sweep("-m", "seed=1,2", "recording.sweep=mine")[0] == 0
    assert ran == [1, 2]
    status, _ = sweep("-m", "seed=1,2", "recording.sweep=mine", "motion.seconds=3")
    assert "mine' holds another sweep, of seed with the defaults: choose another" in status
    assert ran == [1, 2]


def test_a_failed_run_is_listed_stops_nothing_and_is_tried_again(sweep, ran):
    status, out = sweep("-m", "seed=13,2")
    assert status.startswith("silpose: 1 of 2 runs failed, as listed above")
    assert "seed_13 failed: unexpected ValueError: no luck" in out
    assert "Traceback" not in out
    assert "Traceback" in (folder_of("seed") / "seed_13" / "failed.txt").read_text()
    assert "no luck" in (folder_of("seed") / "sweep.csv").read_text()
    sweep("-m", "seed=13,2")
    assert ran == [13, 2, 13]


def test_ctrl_c_keeps_what_is_finished(sweep, ran, monkeypatch):
    finish = __import__("silpose.app.run", fromlist=["run"]).run_experiment

    def interrupted(settings):
        if settings.seed == 2:
            raise KeyboardInterrupt
        return finish(settings)

    monkeypatch.setattr("silpose.app.run.run_experiment", interrupted)
    status, out = sweep("-m", "seed=1,2,3")
    assert "interrupted: the same command goes on where it stopped" in status
    assert "seed_1" in out
    monkeypatch.setattr("silpose.app.run.run_experiment", finish)
    assert sweep("-m", "seed=1,2,3")[0] == 0
    assert ran == [1, 2, 3]


def test_a_sweep_is_started_by_its_name_alone(sweep, ran):
    status, out = sweep("sweep=seeds", "seed=3,4")
    assert status == 0
    assert ran == [3, 4]
    assert folder_of("seeds").is_dir()
    assert "over 2 seeds" in out


def test_a_sweep_of_experiments_has_a_folder_in_each(sweep, ran):
    assert sweep("-m", "experiment=single_image,tracking")[0] == 0
    assert len(ran) == 2
    for experiment in ("single_image", "tracking"):
        assert len(list(Path("recordings", experiment).glob("*/*/metrics.json"))) == 1


def test_descriptors_are_shared_unless_told_otherwise(sweep, monkeypatch, tmp_path):
    caches = []
    finish = __import__("silpose.app.run", fromlist=["run"]).run_experiment

    def remember(settings):
        caches.append(settings.dataset.cache)
        return finish(settings)

    monkeypatch.setattr("silpose.app.run.run_experiment", remember)
    sweep("-m", "seed=1")
    sweep("-m", "seed=2", "dataset.cache=null")
    assert caches == [str(tmp_path / "recordings/.cache"), None]


WRONG = {
    "-m seed=1,2 recording.name=x": "in a sweep runs are named by what they vary",
    "-m sead=1,2": "there is no setting 'sead'; did you mean 'seed'?",
    "-m motion=walker,walkr": "there is no motion=walkr; did you mean 'walker'?",
    "-m seed=interval(1,3)": "list them, or add hydra/sweeper=optuna",
    "-m seed=1,2 recording.sweep=a/b": "recording.sweep must be the name of one folder",
    "sweep=sedes": "there is no sweep=sedes; did you mean 'seeds'?",
    "-m seed=1,2 hydra/launcher=joblb": "there is no hydra/launcher=joblb",
    "-m experiment=glob(no*) seed=1": "has no values to run",
}


@pytest.mark.parametrize("arguments", WRONG)
def test_what_is_wrong_is_one_sentence_before_anything_runs(sweep, ran, arguments):
    status, _ = sweep(*arguments.split())
    assert status.startswith("silpose: ")
    assert WRONG[arguments] in status
    assert "\n" not in status
    assert not ran
    assert not list(Path().rglob("metrics.json"))
