"""Speed and errors of sparse regressors: python benchmarks/regression.py [--fast] [AGARWAL.mat].

Speed on 2636 kernels and 55 outputs of walkers, the size of the paper's; errors on the walkers'
test take and, where the authors' file is given, on theirs. Compares with `fastrvm` if that is
installed. With ``--fast``, 300 kernels.
"""

import sys
import tracemalloc
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter

import numpy as np
from sklearn.linear_model import ARDRegression
from timing import FAST, report

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array, Indices
from silpose.dataset import AgarwalFile, Dataset, Renderer, SamePerformer
from silpose.descriptor import ShapeContextHistogram
from silpose.model import describe_dataset
from silpose.motion import WalkerTakes
from silpose.regression import Basis, Regressor, RelevanceVectorRegressor, RidgeRegressor
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.sparse import eliminate

COUNT = 300 if FAST else 2636
ROUNDS = 1 if FAST else 3
BASIS = Basis(width=2.0)
DAMPING = 0.01


@dataclass
class Examples:
    """Training frames and a test take, described."""

    z: Array
    x: Array
    z_test: Array
    x_test: Array
    space: PoseSpace


def describe(data: Dataset, count: int) -> Examples:
    """Describe the first training frames, and the first test take."""
    described = describe_dataset(data, ShapeContextHistogram())
    z, x = described.joined("train")
    return Examples(z[:count], x[:count], *described.test[0], data.space)


def walkers() -> Examples:
    """Render walkers and describe them."""
    source = WalkerTakes(seconds=4, test_seconds=4) if FAST else WalkerTakes(seconds=22)
    return describe(SamePerformer().load(Renderer(source)), COUNT)


def authors(path: str) -> Examples:
    """Read the authors' 1927 training and 418 test frames."""
    return describe(AgarwalFile(path).load(Renderer(WalkerTakes())), COUNT)


def clock(work: Callable[[], object]) -> float:
    """Seconds of the fastest round."""
    took = []
    for _ in range(ROUNDS):
        started = perf_counter()
        work()
        took.append(perf_counter() - started)
    return min(took)


def speed(data: Examples) -> None:
    """Time one ridge solve, the RVM, and other sparse regressors for each output."""
    z, x = data.z, data.x
    basis = BASIS.fit(z)
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
    RelevanceVectorRegressor(BASIS, nu=50).fit(z, x)
    peak = tracemalloc.get_traced_memory()[1] / kernels.nbytes
    tracemalloc.stop()
    for name, fit in others(kernels).items():
        y = x[:, np.flatnonzero(x.std(axis=0) > 1)[0]]
        seconds, kept = fit((y - y.mean()) / y.std())
        row(f"{name}, one output times {x.shape[1]}", seconds * x.shape[1], kept)
    report(
        f"fitting {len(z)} x {len(z)} Gaussian kernels; the RVM's peak memory from z to fit is "
        f"{peak:.1f} kernel matrices",
        ["what", "seconds", "of a solve", "kept per output"],
        rows,
    )


def others(kernels: Array) -> dict[str, Callable[[Array], tuple[float, float]]]:
    """Sparse regressors of a single output: each returns its seconds and the share kept."""

    def ard(y: Array) -> tuple[float, float]:
        machine = ARDRegression(max_iter=3)
        started = perf_counter()
        machine.fit(kernels, y)
        return perf_counter() - started, float((machine.lambda_ < machine.threshold_lambda).mean())

    found = {"ARDRegression, 3 iterations": ard}
    try:
        from fastrvm import RVR
    except ModuleNotFoundError:
        return found

    def fast(y: Array) -> tuple[float, float]:
        machine = RVR(kernel="precomputed", max_iter=3000)
        started = perf_counter()
        machine.fit(kernels, y)
        return perf_counter() - started, len(machine.relevance_) / len(kernels)

    return {"fastrvm, 3000 iterations at most": fast, **found}


def quality(data: Examples, name: str) -> None:
    """Compare test errors with a random subset and forward selection of the same two sizes."""
    z, x = data.z, data.x
    basis = BASIS.fit(z)
    kernels, kernels_test = basis.transform(z), basis.transform(data.z_test)
    system = NormalEquations.of(kernels, x)

    def error(estimated: Array) -> float:
        return float(data.space.distance(data.x_test, estimated).mean())

    def of_subset(kept: Indices) -> float:
        some = system.restrict(kept)
        coefficients, offset = some.unscaled(some.solve(DAMPING), slice(None))
        return error(kernels_test[:, kept] @ coefficients + offset)

    def of_regressor(regressor: Regressor) -> float:
        regressor.fit_system(basis, system)
        return error(regressor.predict(data.z_test))

    counts = [int(share * len(z)) for share in (0.06, 0.18)]
    forward = forward_selection(kernels, x, max(counts))
    dense = of_regressor(RidgeRegressor(damping=DAMPING))
    rows = [["dense kernel ridge", f"{dense:.3f}", f"{dense:.3f}"]]
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
        f"{name}: {data.space.metrics[0].replace('_', ' ')} on the test take",
        ["what", *(f"{n / len(z):.0%} kept" for n in counts)],
        rows,
    )


def forward_selection(kernels: Array, x: Array, count: int) -> Indices:
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
    for path in sys.argv[1:]:
        if path != "--fast":
            quality(authors(path), "the authors' data")
