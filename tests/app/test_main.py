import csv
import re
import subprocess
import sys

import cv2
import numpy as np
import pytest

from silpose.app.config import plain
from silpose.app.main import main
from silpose.core.errors import InputError
from silpose.recording.viewer.process import program


@pytest.fixture
def run(tmp_path, monkeypatch, capfd):
    """Run the command in an empty folder; give exit status, output and error output."""
    monkeypatch.chdir(tmp_path)

    def command(*arguments):
        monkeypatch.setattr(sys, "argv", ["silpose", *arguments])
        try:
            main()
            status = 0
        except SystemExit as stop:
            status = stop.code
        out, err = capfd.readouterr()
        return status, out, err

    return command


def test_a_whole_run_says_how_to_open_it(run, fast, tmp_path):
    status, out, _ = run(*fast)
    assert status == 0
    assert "rvm_20" in out
    assert "recordings/single_image/001/run.rrd" in out
    assert {f.name for f in (tmp_path / "recordings/single_image/001").iterdir()} == {
        "config.yaml",
        "metrics.json",
        "model.npz",
        "results.csv",
        "run.rrd",
        "single_image.png",
    }


def test_the_version_is_told(run):
    status, out, _ = run("--version")
    assert status == 0 and re.match(r"silpose \d+\.\d+", out)


def test_a_stage_is_named_before_anything_heavy_is_loaded(run):
    _, _, err = run("seed=x")
    assert err.splitlines()[0] == "loading …"


@pytest.mark.parametrize("path", ["-a, [b]='c' ${seed}", "x=1,2", "a\\", "--help me"])
def test_a_path_is_untouched_in_every_job_of_a_sweep(run, tmp_path, monkeypatch, path):
    sources = []

    def remember(settings):
        sources.append(plain(settings)["silhouette"]["source"])
        raise InputError("no need to run")

    (tmp_path / path).mkdir()
    monkeypatch.setattr("silpose.app.run.run_experiment", remember)
    status, _, _ = run("predict", path, "-m", "lag=0.1,0.2")
    assert "2 of 2 runs failed" in status
    assert sources == [str(tmp_path / path)] * 2


def test_the_same_seed_gives_the_same_recording(run, fast, finished, tmp_path):
    status, _, _ = run(*fast, "recording.root=elsewhere", "recording.name=small")
    assert status == 0
    again = tmp_path / "elsewhere/single_image/small/run.rrd"
    command = [program(), "rrd", "compare", "--unordered", finished.recording]
    assert subprocess.run([*command, again], capture_output=True).returncode == 0


def test_ones_own_masks_by_a_saved_model(run, finished, mask_folder, tmp_path):
    odd = mask_folder.rename(mask_folder.with_name("-my, [masks]=1 '$"))
    status, _, _ = run("predict", str(odd), f"model={finished.folder}", "silhouette.blank=nan")
    odd.rename(mask_folder)
    assert status == 0
    with (tmp_path / "recordings/predict/001/poses.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [row["file"] for row in rows] == [f"{frame}.png" for frame in range(12)]
    assert [row["heading_deg"] == "nan" for row in rows] == [frame == 5 for frame in range(12)]
    assert {row["root_y_m"] for row in rows} == {"0", "nan"}


WRONG = {
    "motion=bvh": "'motion.root' is not set",
    "motion=bvh motion.root=nowhere": "nowhere",
    "motion=bvh motion.root=empty": "empty: no .bvh or .amc files",
    "motion=bvh motion.root=text": "text/a.bvh",
    "dataset=cross_performer": "fitted to all performers",
    "dataset=cross_camera silhouette.scenes.elevation=[0,30]": "meets the training's [0, 30]",
    "silhouette.scenes.frames=0": "silhouette.scenes.frames must be at least 1, not 0",
    "silhouette/scenes=widest": "there is no silhouette/scenes=widest",
    "experiment=training_data": "fitted to all performers",
    "motion=amass motion.root=empty": "empty: no .npz files",
    "motion=bvh motion.root=text motion.strict=true": "text/a.bvh",
    "motion=walkr": "there is no motion=walkr; did you mean 'walker'?",
    "motion.secnds=3": "no setting 'motion.secnds'; did you mean 'motion.seconds'?",
    "+motion.second=3": "no setting 'motion.second'; did you mean 'motion.seconds'?",
    "~motion": "'motion' cannot be deleted: leave out '~motion'",
    "recording.name=": "name of one folder, not ''",
    "recording.name=..": "name of one folder, not '..'",
    "seed=x": "'seed' must be an integer, not 'x'",
    "nonsense": "there is no command 'nonsense'; there are catalog, compare",
    "predct masks": "there is no command 'predct'; did you mean 'predict'?",
    "tracking seed=1": "'tracking' is an experiment: silpose experiment=tracking seed=1",
    "seed=1 nonsense": "cannot read 'nonsense'",
    "n_jobs=0": "n_jobs must be an integer other than 0",
    "motion=bvh motion.root=x motion.rot=y": "did you mean 'motion.root'?",
    "descriptor.edge_points=many": "'descriptor.edge_points' must be an integer",
    "descriptor.kind=hog": "no 'descriptor.kind=hog'",
    "regression.rvm.nu=-1": "regression.rvm.nu must be positive or 'auto', not -1",
    "methods=[ridge,foo]": "no method 'foo'",
    "show=knn": "show=knn is none of the methods",
    "dataset.test=[zzz]": "no take matches 'zzz' in dataset.test",
    "silhouette.camera.distance=-1": "distance must be positive",
    "silhouette.body.shape=[1,2]": "10 coefficients, not 2",
    "silhouette.degradation.test=[hole]": "no degradation 'hole'",
    "silhouette.degradation.strength=2": "strength must be from 0 to 1, not 2",
    "recording.root=file": "cannot write to 'file/single_image'",
    "recording.name=a/b": "name of one folder",
    "recording=screen": "there is no recording=screen; there are file, none, viewer, web",
    "recording.sinks=[fil]": "recording.sinks must list any of file, viewer, web, not 'fil'",
    "recording.sinks=file": "'recording.sinks' must be a list",
    "recording.web_port=x": "'recording.web_port' must be an integer",
    "experiment=predict": "add silhouette=masks silhouette.source=FOLDER",
    "predict nowhere": "no file or folder 'nowhere'",
    "masks nowhere": "no file or folder 'nowhere'",
    "predict model=file": "there is no file 'model=file'; the path comes first",
    "predict": "'predict' needs a path",
    "experiment=predict silhouette=masks silhouette.source=empty": "holds no masks",
    "experiment=predict silhouette=masks silhouette.source=blank": "'0.png' has no fore",
    "experiment=predict silhouette=masks silhouette.source=good model=file": "no silpose model",
    "silhouette=masks silhouette.source=good": "add experiment=predict",
}


@pytest.mark.parametrize("arguments", WRONG)
def test_what_is_wrong_is_one_sentence_and_leaves_nothing(run, tmp_path, arguments):
    for folder in ("empty", "text", "blank", "good"):
        (tmp_path / folder).mkdir()
    (tmp_path / "text" / "a.bvh").write_text("hello")
    (tmp_path / "file").touch()
    cv2.imwrite(str(tmp_path / "blank" / "0.png"), np.zeros((9, 9), np.uint8))
    cv2.imwrite(str(tmp_path / "good" / "0.png"), np.eye(9, dtype=np.uint8))
    status, out, err = run(*arguments.split())
    assert isinstance(status, str)  # which Python prints, and exits with status 1
    assert status.startswith("silpose: ")
    assert WRONG[arguments] in status
    assert "\n" not in status
    assert "Traceback" not in out + err
    assert not list(tmp_path.glob("recordings/**/*.*"))


def test_debug_shows_where_an_error_comes_from(run):
    with pytest.raises(Exception, match=r"motion\.root"):
        run("motion=bvh", "debug=true")


def test_a_run_without_a_recording_does_not_load_rerun(fast, tmp_path):
    code = (
        "import sys, silpose; silpose.run_experiment(sys.argv[1:]);"
        "print({'rerun', 'rerun_bindings'} & set(sys.modules))"
    )
    settings = [*fast, "recording=none", f"recording.root={tmp_path}", "recording.name=small"]
    shown = subprocess.run(
        [sys.executable, "-c", code, *settings], capture_output=True, text=True, check=True
    )
    assert shown.stdout.splitlines()[-1] == "set()"
    assert "Open it" not in shown.stdout
    folder = tmp_path / "single_image" / "small"
    assert {"metrics.json", "model.npz"} <= {file.name for file in folder.iterdir()}
    assert not list(folder.glob("*.rrd"))


def test_help_and_import_do_not_wait_for_heavy_packages():
    heavy = {"rerun", "sklearn", "scipy", "numba", "cv2", "matplotlib", "numpy", "hydra", "griffe"}
    code = (
        "import sys, silpose, silpose.app.main; sys.argv[1:] = ['--help']; silpose.app.main.main();"
        f"print({heavy!r} & set(sys.modules))"
    )
    shown = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert shown.stdout.splitlines()[-1] == "set()"
    assert "single_image" in shown.stdout
    assert "predict PATH" in shown.stdout


def test_settings_are_explained_without_importing_what_they_are_for(run):
    code = (
        "import sys; from silpose.app.settings_table import print_settings;"
        "print_settings(['regression', 'tracking', 'experiment']);"
        "print({'sklearn', 'scipy', 'numba', 'cv2', 'numpy'} & set(sys.modules))"
    )
    shown = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert shown.stdout.splitlines()[-1] == "set()"


def test_a_verb_shows_what_it_is_short_for(run):
    status, out, _ = run("predict", "--help")
    assert status == 0
    assert "silpose predict PATH" in out
    assert "experiment=predict silhouette=masks silhouette.source=PATH" in out
