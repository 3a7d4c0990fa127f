"""How exactly the kernels' widths must be met: section V-A of the paper, "tolerance"."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.core.errors import InputError
from silpose.experiments.setup import Components
from silpose.model.tracker_training import TrackerTraining, learn_to_track
from silpose.recording import record_study
from silpose.recording.runs.run_folder import Run
from silpose.tracking import GIVEN, BeliefTracker, Estimate

Array = NDArray[np.float64]


def kernel_widths(rooms: Components, run: Run, factors: Sequence[float]) -> None:
    """Multiply β_x and β_z, as chosen, by factors, for the paper's tracker and for ours.

    Parameters
    ----------
    rooms : Components
    run : Run
    factors : sequence of float
    """
    if not factors or min(factors) <= 0:
        raise InputError(f"factors must be positive, not {list(factors)}")
    learnt = learn_to_track(rooms, run)
    described, space = learnt.described, learnt.described.data.space
    rows: list[dict[str, object]] = []
    series: dict[str, Array] = {}
    grids = {}
    with run.stage("tracking"):
        for method, make in (("joint", _joint(learnt)), ("tracker", _tracker(learnt))):
            grids[method] = np.empty((len(factors), len(factors)))
            for i, on_x in enumerate(factors):
                for j, on_z in enumerate(factors):
                    estimate = make(on_x, on_z)
                    errors = [space.distance(x, estimate(z, x[:GIVEN])) for z, x in described.test]
                    grids[method][i, j] = np.concatenate(errors).mean()
                    row = {"method": method, "beta_x_factor": on_x, "beta_z_factor": on_z}
                    rows.append({**row, "error": float(grids[method][i, j])})
                    if on_z == 1:
                        series[f"{method} {on_x:g}"] = errors[0]
    metrics = {
        method: {"error": float(grid.min()), "widest_error": float(grid.max())}
        for method, grid in grids.items()
    }
    with run.writing("kernel_widths.png") as path:
        _figure(path, factors, grids)
    record_study(
        run.header("tolerance in the kernels' widths", metrics),
        run.folder / "kernel_widths.png",
        series,
        "error for several β_x",
        described.data.test[0].frames_per_second,
    )
    run.write_settings()
    run.write_results([*learnt.selection.rows, *rows])
    run.write_metrics(described.data.name, rooms.seed, metrics)


def _joint(learnt: TrackerTraining) -> Callable[[float, float], Estimate]:
    def make(on_x: float, on_z: float) -> Estimate:
        chosen = learnt.joint.regressor
        tracker = learnt.joint_with(
            pose_width=chosen.pose_width * on_x, descriptor_width=chosen.descriptor_width * on_z
        )
        return lambda z, start: tracker.track(z, start)[0]

    return make


def _tracker(learnt: TrackerTraining) -> Callable[[float, float], Estimate]:
    chosen: BeliefTracker = learnt.tracker
    keys = chosen.key_poses(learnt.described.train)

    def make(on_x: float, on_z: float) -> Estimate:
        tracker = clone(chosen).set_params(
            pose_width=chosen.pose_width / np.sqrt(on_x),  # standard deviations, not β
            descriptor_width=chosen.descriptor_width / np.sqrt(on_z),
        )
        tracker.use_fitted(keys)
        return lambda z, _: tracker.track(z).x

    return make


def _figure(path: Path, factors: Sequence[float], grids: dict[str, Array]) -> None:
    figure = Figure(figsize=(10, 4.5), layout="constrained")
    ticks = [f"{f:g}" for f in factors]
    for axes, (method, grid) in zip(figure.subplots(1, len(grids)), grids.items(), strict=True):
        axes.imshow(grid, cmap="magma_r", origin="lower", vmin=grid.min(), vmax=2 * grid.min())
        for (i, j), value in np.ndenumerate(grid):
            colour = "white" if value > 1.5 * grid.min() else "black"
            axes.text(j, i, f"{value:.2f}", ha="center", va="center", fontsize=8, color=colour)
        axes.set_xticks(range(len(ticks)), ticks)
        axes.set_yticks(range(len(ticks)), ticks)
        axes.set(xlabel="factor of β_z", ylabel="factor of β_x", title=method)
    figure.savefig(path, dpi=120, format="png")
