import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path
from random import Random

from silpose.recording.runs.sweep_folder import write_definition

RUNS = 200
SCRIPT = """
import sys, time, types
from pathlib import Path
from omegaconf import OmegaConf
from silpose.recording import Result, RunFolder, load_run, write_result

def run_experiment(settings):
    with open(log, "a") as file:
        file.write(f"{settings.recording.name}\\n")
    own = settings.recording
    folder = RunFolder.start("e", "seed: 0", root=own.root, name=own.name, sweep=own.sweep)
    time.sleep(0.002)
    write_result(folder, Result("walker", {}, headline=1.5), 0, {"fit": 0.1})
    return load_run(folder.folder)

sys.modules["silpose.app.run"] = types.SimpleNamespace(run_experiment=run_experiment)
from silpose.app.sweep.job import run_in_sweep

root, log, runs = sys.argv[1:]
for seed in range(int(runs)):
    recording = {"root": root, "sweep": "s", "name": None}
    settings = OmegaConf.create({"experiment": "e", "seed": seed, "recording": recording})
    assert run_in_sweep(settings, [f"seed={seed}"], alone=False) == 1.5
"""


def start(tmp_path):
    write_definition(tmp_path / "e" / "s", {"varied": ["seed"]})
    command = [sys.executable, "-c", SCRIPT, tmp_path, tmp_path / "log", str(RUNS)]
    return subprocess.Popen([*map(str, command)], stdout=subprocess.DEVNULL)


def finished(root):
    return {file.parent.name for file in Path(root).rglob("metrics.json")}


def test_a_sweep_of_200_runs_killed_at_a_random_moment_repeats_none(tmp_path):
    killed = start(tmp_path)
    enough = Random().randrange(1, 150)
    while len(finished(tmp_path)) < enough:
        time.sleep(0.005)
    killed.send_signal(signal.SIGKILL)
    killed.wait()
    before = finished(tmp_path)
    assert 0 < len(before) < RUNS
    first, second = start(tmp_path), start(tmp_path)  # and two at once do nothing twice
    assert first.wait() == second.wait() == 0
    times = Counter((tmp_path / "log").read_text().split())
    assert len(finished(tmp_path)) == RUNS
    assert all(times[name] == 1 for name in before)
    assert sum(times.values()) <= RUNS + 1  # the one that was cut off
