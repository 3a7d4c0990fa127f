"""What recordings cost: python benchmarks/recording.py.

Logging a tracked sequence of 400 frames beyond the start-up of the first stream, listing 200 runs,
comparing two, reading one back.
"""

from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from timing import per_second, report

from silpose import load_run, runs_table
from silpose.app.config import build_components, load
from silpose.core.pose_space import ANGLES
from silpose.recording import Truth, compare, record_tracking
from silpose.recording.runs.run_folder import Run
from silpose.tracking import Track

FRAMES = 400
METHODS = ("ridge", "dynamics", "joint", "tracker")


def tracked(run: Run) -> None:
    """Record what `experiment=tracking` records, estimates being the truth and some noise."""
    record_tracking(run.header("a walk", METRICS), TAKE, TRUTH, ESTIMATES, TRACK, ANGLES)


def finish(run: Run) -> Run:
    run.write_settings()
    run.write_metrics("walker", 0, METRICS)
    return run


if __name__ == "__main__":
    rooms = build_components(load([f"motion.test_seconds={FRAMES / 15}", "motion.seconds=2"]))
    TAKE = rooms.dataset().test[0]
    rng = np.random.default_rng(0)
    ESTIMATES = {m: TAKE.x + rng.normal(size=TAKE.x.shape) for m in METHODS}
    errors = {m: ANGLES.distance(TAKE.x, x) for m, x in ESTIMATES.items()}
    METRICS = {m: {"mean_angular_error_deg": float(e.mean())} for m, e in errors.items()}
    TRUTH = Truth.of(TAKE, rooms.camera, errors, ANGLES)
    beliefs = rng.dirichlet(np.full(370, 0.1), len(TAKE))
    TRACK = Track(TAKE.x, ["tracking"] * len(TAKE), beliefs)
    with TemporaryDirectory() as folder:
        runs = [Run.start(folder, "tracking", name, "seed: 0\n") for name in ("a", "b")]
        for run in runs:
            tracked(finish(run))  # the first pays for the start-up
        size = (runs[0].folder / "run.rrd").stat().st_size
        for k in range(200):
            finish(Run.start(f"{folder}/many", "tracking", settings=f"seed: {k}\n"))
        both = [load_run(run.folder) for run in runs]
        work = {
            f"logging {len(TAKE)} tracked frames, {size / 1e6:.1f} MB": lambda: tracked(runs[0]),
            "comparing two such runs": lambda: compare(both, Path(folder) / "both.rrd"),
            "reading one's tracks as a table": lambda: load_run(runs[0].folder).tracks,
            "listing 200 runs": lambda: runs_table(f"{folder}/many"),
        }
        report(
            "recordings",
            ["what", "seconds"],
            [[name, f"{1 / per_second(call, 1):.2f}"] for name, call in work.items()],
        )
