"""Sweeps side by side, and with shared descriptors: python benchmarks/sweeps.py [--fast].

The same runs, which differ in how they are regressed, by each way of running them; with
``--fast`` fewer and smaller ones. ``--launcher=NAME`` adds another launcher.
"""

import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

from timing import FAST, report

JOBLIB = find_spec("hydra_plugins.hydra_joblib_launcher") if find_spec("hydra_plugins") else None
RUNS = 2 if FAST else 16
SECONDS = 3 if FAST else 20  # of motion
SMALL = [
    *(f"motion.seconds={SECONDS}", "methods=[ridge]", "show=ridge", "recording=none"),
    *("silhouette.camera.width=96", "silhouette.camera.height=96") * FAST,
    *("regression.basis.width=2", "regression.ridge.damping=0.1"),
]
WAYS = {
    "one after the other, one thread": ("n_jobs=1", "dataset.cache=null"),
    "one after the other, all cores": ("dataset.cache=null",),
    "joblib": ("hydra/launcher=joblib", "dataset.cache=null"),
    "joblib, shared descriptors": ("hydra/launcher=joblib",),
    **{
        f"{name}, shared descriptors": (f"hydra/launcher={name}",)
        for name in (a.removeprefix("--launcher=") for a in sys.argv if a.startswith("--launcher="))
    },
}


def took(more: tuple[str, ...]) -> float:
    """Seconds of a whole sweep, start-up included."""
    slacks = ",".join(f"{0.01 * (k + 1):.2f}" for k in range(RUNS))
    command = [sys.executable, "-m", "silpose.app.main", "-m", *SMALL, *more]
    one_thread = {name: "1" for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS")}
    with TemporaryDirectory() as folder:
        started = perf_counter()
        subprocess.run(
            [*command, f"regression.slack={slacks}", f"recording.root={folder}"],
            env=os.environ | one_thread,
            stdout=subprocess.DEVNULL,
            check=True,
        )
        seconds = perf_counter() - started
        assert len(list(Path(folder).rglob("metrics.json"))) == RUNS
    return seconds


if __name__ == "__main__":
    ways = {way: more for way, more in WAYS.items() if JOBLIB or not way.startswith("joblib")}
    if FAST:  # most of which is start-up
        ways = dict(list(ways.items())[-1:])
    seconds = {way: took(more) for way, more in ways.items()}
    first = next(iter(seconds.values()))
    rows = [[way, f"{s:.1f}", f"{s / RUNS:.1f}", f"{first / s:.2f}"] for way, s in seconds.items()]
    report(f"{RUNS} runs", ["way", "seconds", "seconds a run", "times as fast"], rows)
