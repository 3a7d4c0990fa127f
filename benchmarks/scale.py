"""Training from blocks on disk: python benchmarks/scale.py [--fast] [FOLDER].

Time and memory with the number of frames and of basis functions, for 55 outputs: ridge and the
RVM from sums over blocks, two workers, beside plain NumPy on the same blocks; mixtures from the
same blocks; and with the number of key poses, belief trackers from takes that are functions. Frames
are walkers', described, mixed in pairs and perturbed; a million of them take 0.7 GB in FOLDER, a
temporary one by default. With ``--fast``, a few thousand.
"""

import os
import sys
import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from time import perf_counter, process_time

import numpy as np
from joblib.externals.loky import get_reusable_executor
from numpy.lib.format import open_memmap
from threadpoolctl import threadpool_limits
from timing import FAST, report

from silpose.core.parallel import engine
from silpose.core.types import Array, Examples
from silpose.dataset import Renderer, SamePerformer
from silpose.descriptor import ShapeContextHistogram
from silpose.model import describe_dataset
from silpose.motion import WalkerTakes
from silpose.regression import (
    Basis,
    FileBlock,
    MixtureOfRegressors,
    RelevanceVectorRegressor,
    RidgeRegressor,
    file_blocks,
)
from silpose.regression.examples import StreamedExamples
from silpose.tracking import BeliefTracker

FRAMES = (4_000, 8_000, 20_000) if FAST else (100_000, 200_000, 1_000_000)
CENTRES = 100 if FAST else 2000
FEW = CENTRES // 4
DAMPING, NU = 0.1, 0.02  # ν per frame: what it is weighed against is a sum over frames
WORKERS = 2
KEY_POSES = ((200, 1_500), (600, 3_000)) if FAST else ((1_800, 10_000), (20_000, 110_000))
CLUSTERS = 20 if FAST else 120
STEPS = 200


def real_takes() -> Examples:
    """Descriptors and poses of walkers, in takes of equal length."""
    source = WalkerTakes(seconds=4 if FAST else 22, test_seconds=4)
    described = describe_dataset(SamePerformer().load(Renderer(source)), ShapeContextHistogram())
    return described.train


def perturbed_take(takes: Examples, number: int) -> tuple[Array, Array]:
    """Make a take between two real ones, frame by frame, with noise."""
    rng = np.random.default_rng(number)
    (z, x), (other_z, other_x) = (takes[k] for k in rng.integers(len(takes), size=2))
    share = 0.3 * rng.random()
    mixed = (1 - share) * z + share * other_z
    mixed *= np.exp(0.1 * rng.normal(size=mixed.shape))
    poses = (1 - share) * x + share * other_x
    return mixed / mixed.sum(axis=1, keepdims=True), poses + rng.normal(size=x.shape) * 0.1


def write_frames(folder: Path, takes: Examples, count: int) -> tuple[Path, Path]:
    """Write frames between pairs of real ones, with noise."""
    z, x = map(np.concatenate, zip(*takes, strict=True))
    files = folder / "z.npy", folder / "x.npy"
    tables = [
        open_memmap(file, "w+", np.float32, (count, real.shape[1]))
        for file, real in zip(files, (z, x), strict=True)
    ]
    rng = np.random.default_rng(0)
    for start in range(0, count, 10_000):
        size = min(10_000, count - start)
        a, b = rng.integers(len(z), size=(2, size))
        share = 0.3 * rng.random((size, 1))
        mixed = (1 - share) * z[a] + share * z[b]
        mixed *= np.exp(0.1 * rng.normal(size=mixed.shape))
        tables[0][start : start + size] = mixed / mixed.sum(axis=1, keepdims=True)
        poses = (1 - share) * x[a] + share * x[b]
        tables[1][start : start + size] = poses + rng.normal(size=poses.shape) * 0.1
    for table in tables:
        table.flush()
    return files


def plain_numpy(blocks: list[FileBlock], basis: Basis) -> float:
    """CPU seconds of the kernel blocks, FᵀF and FᵀY, and no more than that."""
    centres, started = basis.centres_, process_time()
    own = (centres**2).sum(axis=1)
    gram, target = 0.0, 0.0
    for block in blocks:
        z, x = block()
        z = np.sqrt(z)
        distances = z @ centres.T * -2 + (z**2).sum(axis=1)[:, None] + own
        f = np.exp(-basis.beta_ * distances)
        gram, target = gram + f.T @ f, target + f.T @ x
    return process_time() - started


def peak_gigabytes() -> float:
    """Sum of the largest memory of this process and of each of its workers, as Linux counts it."""
    processes = [str(os.getpid())]
    for task in Path("/proc/self/task").glob("*/children"):
        processes += task.read_text().split()
    peaks = [Path("/proc", process, "status").read_text() for process in processes]
    return sum(int(text.split("VmHWM:")[1].split()[0]) for text in peaks) / 2**20


def seconds(work: Callable[[], object]) -> tuple[float, object]:
    """Seconds by the clock, and the outcome."""
    started = perf_counter()
    outcome = work()
    return perf_counter() - started, outcome


def measure(blocks: list[FileBlock], centres: int, choice: str) -> list[str]:
    """Fit ridge and RVM to blocks, two workers; one row of the table."""
    basis = Basis(width=2.0, centres=centres, choice=choice)
    count = sum((block.stop or 0) - (block.start or 0) for block in blocks)
    with engine("joblib", n_jobs=WORKERS):
        survey, examples = seconds(lambda: StreamedExamples(blocks, hellinger=True))
        assert isinstance(examples, StreamedExamples)
        choose, fitted = seconds(lambda: examples.fit(basis))
        assert isinstance(fitted, Basis)
        add, system = seconds(lambda: examples.equations(fitted))
    solve, _ = seconds(lambda: RidgeRegressor(basis, damping=DAMPING).fit_system(fitted, system))
    rvm = RelevanceVectorRegressor(basis, nu=NU * count)
    sparse, _ = seconds(lambda: rvm.fit_system(fitted, system))
    times = (survey, choose, add, solve, sparse)
    row = [f"{count:,}", f"{len(fitted.centres_)}", choice, *(f"{t:.2f}" for t in times)]
    return [*row, f"{rvm.kept_:.0%}", f"{peak_gigabytes():.2f}"]


def against_numpy(blocks: list[FileBlock]) -> list[str]:
    """CPU time of a whole ridge fit over that of plain NumPy, one thread each."""
    basis = Basis(width=2.0, centres=CENTRES)
    ridge = RidgeRegressor(basis, damping=DAMPING)
    with threadpool_limits(1), engine("local"):
        fitted = StreamedExamples(blocks[:2], hellinger=True).fit(basis)
        plain_numpy(blocks[:2], fitted)
        started = process_time()
        ridge.fit_blocks(blocks)
        ours = process_time() - started
        plain = plain_numpy(blocks, ridge.basis_)
    return [f"{FRAMES[0]:,}", f"{ours:.1f}", f"{plain:.1f}", f"{ours / plain:.2f}"]


def forget_peak() -> None:
    """Let the largest memory so far count no more."""
    Path("/proc/self/clear_refs").write_text("5")


def measure_mixture(blocks: list[FileBlock]) -> list[str]:
    """Fit a mixture to blocks, two workers; one row of the table."""
    forget_peak()
    count = sum((block.stop or 0) - (block.start or 0) for block in blocks)
    with engine("joblib", n_jobs=WORKERS):
        fit, mixture = seconds(lambda: MixtureOfRegressors(CLUSTERS).fit_blocks(blocks))
    assert isinstance(mixture, MixtureOfRegressors)
    row = [f"{count:,}", f"{mixture.components_}", f"{mixture.n_iter_}", f"{fit:.1f}"]
    return [*row, f"{peak_gigabytes():.2f}"]


def measure_tracker(takes: Examples, key_poses: int, frames: int) -> list[str]:
    """Fit a tracker to takes that are functions, then track live; one row of the table."""
    get_reusable_executor().shutdown(wait=True)  # idle workers do not count
    forget_peak()
    length = len(takes[0][0])
    functions = [partial(perturbed_take, takes, k) for k in range(-(-frames // length))]
    count = length * len(functions)
    tracker = BeliefTracker(keep=key_poses / count)
    fit, _ = seconds(lambda: tracker.fit(functions))
    peak = peak_gigabytes()
    z, _ = perturbed_take(takes, len(functions))
    stream, took = tracker.start(), []
    with threadpool_limits(1):
        for row in np.resize(z, (STEPS, z.shape[1])):
            started = perf_counter()
            stream.step(row)
            took.append(1000 * (perf_counter() - started))
    known = tracker.transitions_.stored / len(tracker.sizes_)
    return [f"{count:,}", f"{len(tracker.sizes_):,}", f"{known:.0f}", f"{fit:.1f}", f"{peak:.2f}",
            f"{np.median(took):.2f}", f"{np.quantile(took, 0.99):.2f}"]  # fmt: skip


def main(folder: Path) -> None:
    """Measure, and print the tables."""
    takes = real_takes()
    files = write_frames(folder, takes, FRAMES[-1])
    forget_peak()  # what rendering took is no part of training
    every = file_blocks(*files)
    blocks = {count: file_blocks_of(every, count) for count in FRAMES}
    rows = [measure(blocks[FRAMES[0]], FEW, "random")]
    rows += [measure(blocks[count], CENTRES, "random") for count in FRAMES]
    rows.append(measure(blocks[FRAMES[0]], CENTRES, "kmeans"))
    columns = ["frames", "kernels", "choice", "survey s", "centres s", "sums s", "ridge s", "RVM s"]
    report("Fit from blocks, two workers", [*columns, "kept", "peak GB"], rows)
    compared = against_numpy(blocks[FRAMES[0]])
    report("CPU time, one thread", ["frames", "fit_blocks s", "NumPy s", "ratio"], [compared])
    rows = [measure_mixture(blocks[count]) for count in FRAMES[:2]]
    columns = ["frames", "components", "rounds", "fit s", "peak GB"]
    report("Mixture from blocks, two workers", columns, rows)
    rows = [measure_tracker(takes, *each) for each in KEY_POSES]
    columns = ["frames", "key poses", "near each", "fit s", "peak GB", "step ms", "99 %"]
    report("Belief tracker from functions; a step has one thread", columns, rows)


def file_blocks_of(blocks: list[FileBlock], count: int) -> list[FileBlock]:
    """Return the blocks of the first frames."""
    cut = [block for block in blocks if (block.start or 0) < count]
    last = cut[-1]
    return [*cut[:-1], FileBlock(last.inputs, last.outputs, last.start, min(last.stop, count))]


if __name__ == "__main__":
    given = [argument for argument in sys.argv[1:] if not argument.startswith("--")]
    if given:
        Path(given[0]).mkdir(parents=True, exist_ok=True)
        main(Path(given[0]))
    else:
        with tempfile.TemporaryDirectory() as temporary:
            main(Path(temporary))
