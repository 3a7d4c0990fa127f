"""How fast sparse regressors are fitted, and how good they are.

python benchmarks/regression.py [AGARWAL.mat]

Speed on 2636 kernels and 55 outputs of walkers, the size of the paper's; errors, where the
authors' file is given, on its test sequence. Compares with `fastrvm` if that is installed.
"""

import sys
import tracemalloc
import warnings
from collections.abc import Callable
from time import perf_counter

import numpy as np
from sklearn.linear_model import ARDRegression
from timing import report

from silpose.app.config import build_components, load
from silpose.core.pose_space import ANGLES, PoseSpace
from silpose.dataset import AgarwalFile
from silpose.model.training import described
from silpose.regression import Basis, RelevanceVectorRegressor, RidgeRegressor
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.sparse.elimination import eliminate

COUNT, WIDTH, DAMPING = 2636, 2.0, 0.01
Data = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, PoseSpace]


def walkers() -> Data:
    """Photograph 2636 training frames of walkers, and their test sequence."""
    rooms = build_components(load(["motion.seconds=22"]))
    data = rooms.dataset()
    ready = described(rooms, data)
    z, x = (np.concatenate(part)[:COUNT] for part in zip(*ready.train, strict=True))
    return z, x, *ready.test[0], ANGLES


def authors(path: str) -> Data:
    """Read the authors' 1927 training and 418 test frames."""
    data = AgarwalFile(path).dataset()
    z, x = (np.concatenate([getattr(take, name) for take in data.train]) for name in ("z", "x"))
    return z, x, data.test[0].z, data.test[0].x, data.space


def clock(work: Callable[[], object], rounds: int = 3) -> float:
    """Seconds of the fastest round."""
    took = []
    for _ in range(rounds):
        started = perf_counter()
        work()
        took.append(perf_counter() - started)
    return min(took)


def speed(data: Data) -> None:
    """Time one ridge solve, our RVM, and what others need for each output."""
    z, x, *_ = data
    basis = Basis(width=WIDTH, hellinger=True).fit(z)
    kernels = basis.transform(z)
    system = NormalEquations.of(kernels, x)
    ridge = clock(lambda: system.solve(DAMPING))
    rows = [["one dense ridge solve", f"{ridge:.2f} s", "1", "100 %"]]

    def row(name: str, seconds: float, kept: float) -> None:
        rows.append([name, f"{seconds:,.2f} s", f"{seconds / ridge:,.1f}", f"{kept:.1%}"])

    for name, regressor in {
        "RVM, nu=50": RelevanceVectorRegressor(nu=50),
        "RVM, keep_at_most=0.06": RelevanceVectorRegressor(nu=16, keep_at_most=0.06),
    }.items():
        seconds = clock(lambda r=regressor: r.fit_system(basis, system))
        row(f"{name}, all {x.shape[1]} outputs", seconds, regressor.kept_)
    tracemalloc.start()
    RelevanceVectorRegressor(Basis(width=WIDTH, hellinger=True), nu=50).fit(z, x)
    peak = tracemalloc.get_traced_memory()[1] / kernels.nbytes
    tracemalloc.stop()
    for name, fit in others(kernels).items():
        y = x[:, np.flatnonzero(x.std(axis=0) > 1)[0]]
        seconds, kept = fit((y - y.mean()) / y.std())
        row(f"{name}, one output times {x.shape[1]}", seconds * x.shape[1], kept)
    report(
        f"fitting {COUNT} x {COUNT} Gaussian kernels; the RVM's peak memory from z to fit is "
        f"{peak:.1f} kernel matrices",
        ["what", "seconds", "of a solve", "kept per output"],
        rows,
    )


def others(kernels: np.ndarray) -> dict[str, Callable[[np.ndarray], tuple[float, float]]]:
    """Single-output sparse regressors: each gives seconds and share kept."""

    def ard(y: np.ndarray) -> tuple[float, float]:
        machine = ARDRegression(max_iter=3)
        started = perf_counter()
        machine.fit(kernels, y)
        return perf_counter() - started, float((machine.lambda_ < machine.threshold_lambda).mean())

    found = {"ARDRegression, 3 iterations": ard}
    try:
        from fastrvm import RVR
    except ModuleNotFoundError:
        return found

    def fast(y: np.ndarray) -> tuple[float, float]:
        machine = RVR(kernel="precomputed", max_iter=3000)
        started = perf_counter()
        machine.fit(kernels, y)
        return perf_counter() - started, len(machine.relevance_) / len(kernels)

    return {"fastrvm, 3000 iterations at most": fast, **found}


def quality(data: Data, name: str) -> None:
    """Test errors at two sizes beside a random subset and forward selection of the same."""
    z, x, z_test, x_test, space = data
    basis = Basis(width=WIDTH, hellinger=True).fit(z)
    kernels, kernels_test = basis.transform(z), basis.transform(z_test)
    system = NormalEquations.of(kernels, x)

    def error(estimated: np.ndarray) -> float:
        return float(space.distance(x_test, estimated).mean())

    def of_subset(kept: np.ndarray) -> float:
        some = system.restrict(kept)
        coefficients, offset = some.unscaled(some.solve(DAMPING), slice(None))
        return error(kernels_test[:, kept] @ coefficients + offset)

    def of_regressor(regressor: RidgeRegressor | RelevanceVectorRegressor) -> float:
        regressor.fit_system(basis, system)
        return error(regressor.predict(z_test))

    counts = [int(share * len(z)) for share in (0.06, 0.18)]
    forward = forward_selection(kernels, x, max(counts))
    rows = [["dense kernel ridge", *[f"{of_regressor(RidgeRegressor(None, DAMPING)):.3f}"] * 2]]
    table = {
        "RVM": lambda n: of_regressor(
            RelevanceVectorRegressor(nu=16, keep_at_most=(n + 0.5) / len(z))
        ),
        "elimination from all": lambda n: of_subset(eliminate(system, np.arange(len(z)), n)),
        "orthogonal forward selection": lambda n: of_subset(forward[:n]),
        "random subset, mean of 5": lambda n: np.mean(
            [of_subset(np.random.default_rng(k).choice(len(z), n, False)) for k in range(5)]
        ),
    }
    rows += [[what, *(f"{call(n):.3f}" for n in counts)] for what, call in table.items()]
    report(
        f"{name}: {space.metrics[0].replace('_', ' ')} on the test sequence",
        ["what", *(f"{n / len(z):.0%} kept" for n in counts)],
        rows,
    )


def forward_selection(kernels: np.ndarray, x: np.ndarray, count: int) -> np.ndarray:
    """Orthogonal least squares, all outputs at once: add what lowers the error most."""
    left = kernels - kernels.mean(axis=0)
    deviation = x.std(axis=0)
    target = (x - x.mean(axis=0)) / np.where(deviation > 1e-9, deviation, 1)
    chosen: list[int] = []
    for _ in range(count):
        power = (left**2).sum(axis=0)
        gain = ((left.T @ target) ** 2).sum(axis=1) / np.maximum(power, 1e-9)
        gain[power < 1e-6] = 0
        gain[chosen] = -1
        chosen.append(int(gain.argmax()))
        direction = left[:, chosen[-1]] / np.sqrt(power[chosen[-1]])
        left -= np.outer(direction, direction @ left)
        target = target - np.outer(direction, direction @ target)
    return np.array(chosen)


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    data = walkers()
    speed(data)
    quality(data, "walkers")
    if len(sys.argv) > 1:
        quality(authors(sys.argv[1]), "the authors' data")
