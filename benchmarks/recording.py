"""Cost of recordings: python benchmarks/recording.py [--fast].

Logging a tracked take of 400 frames after the start-up of the first stream, listing 200 runs,
comparing two runs, reading one back; with ``--fast``, fewer frames and runs.
"""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from timing import FAST, per_second, report

from silpose.core.pose_space import ANGLES
from silpose.core.types import Metrics
from silpose.dataset import Renderer, SamePerformer, Take
from silpose.motion import WalkerTakes
from silpose.recording import (
    GroundTruth,
    Header,
    Recording,
    Result,
    RunFolder,
    compare,
    load_run,
    record_tracking,
    runs_table,
    write_result,
)
from silpose.silhouette import Camera
from silpose.tracking import Track

FRAMES = 60 if FAST else 400
RUNS = 20 if FAST else 200
METHODS = ("ridge", "dynamics", "state_sensitive", "tracker")
KEY_POSES = 370


def walk() -> Take:
    """Render a take of as many frames as are recorded."""
    walkers = WalkerTakes(seconds=2, test_seconds=FRAMES / 15)
    return SamePerformer().load(Renderer(walkers)).test[0]


def tracked(take: Take) -> tuple[Metrics, Callable[[Header], None]]:
    """Metrics and recording of ``experiment=tracking``, estimates being the truth with noise."""
    rng = np.random.default_rng(0)
    estimates = {method: take.x + rng.normal(size=take.x.shape) for method in METHODS}
    errors = {method: ANGLES.distance(take.x, x) for method, x in estimates.items()}
    beliefs = rng.dirichlet(np.full(KEY_POSES, 0.1), len(take))
    write = partial(
        record_tracking,
        take=take,
        truth=GroundTruth.of(take, Camera(), errors, ANGLES),
        tracks=estimates,
        track=Track(take.x, ["tracking"] * len(take), beliefs),
        facing=rng.uniform(-180, 180, KEY_POSES),
        space=ANGLES,
    )
    return {m: {"mean_angular_error_deg": float(e.mean())} for m, e in errors.items()}, write


if __name__ == "__main__":
    take = walk()
    metrics, write = tracked(take)
    with TemporaryDirectory() as root:
        folders = [RunFolder.start("tracking", root=root) for _ in range(2)]
        result = Result("walker", metrics, recording=Recording("a walk", write))
        for folder in folders:
            write_result(folder, result, 0, {})
        many = f"{root}/many"
        for seed in range(RUNS):
            folder = RunFolder.start("tracking", f"seed: {seed}\n", root=many)
            write_result(folder, Result("walker", metrics), seed, {})
        runs = [load_run(folder.folder) for folder in folders]
        header = folders[0].header("a walk", metrics)
        megabytes = runs[0].recording.stat().st_size / 1e6
        work: dict[str, Callable[[], object]] = {
            f"logging {len(take)} tracked frames, {megabytes:.1f} MB": lambda: write(header),
            "comparing two such runs": lambda: compare(runs, Path(root) / "both.rrd"),
            "reading one's tracks as a table": lambda: load_run(folders[0].folder).tracks,
            f"listing {RUNS} runs": lambda: runs_table(many),
        }
        rows = [[name, f"{1 / per_second(call, 1):.2f}"] for name, call in work.items()]
    report("recordings", ["what", "seconds"], rows)
