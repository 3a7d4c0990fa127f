"""Tolerance of the trackers to the widths of their kernels: section V-A of the paper."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import product

import numpy as np
from matplotlib.figure import Figure
from sklearn.base import clone

from silpose.core.parallel import parallel_map
from silpose.core.parameters import POSITIVE, check_values
from silpose.core.stages import stage
from silpose.core.types import Array, Row
from silpose.experiments.figures import headline, without_ink
from silpose.experiments.setup import Components, prepare_tracking
from silpose.model import TrackerTraining
from silpose.recording import Recording, Result, palette, record_study
from silpose.recording.captions import coloured, in_words
from silpose.recording.figure_style import styled
from silpose.tracking import Estimate

MakeEstimate = Callable[[float, float], Estimate]
"""From factors of β_x and β_z to a tracker."""


def kernel_widths(
    components: Components, *, factors: Sequence[float] = (0.25, 0.5, 1, 2, 4)
) -> Result:
    """Multiply β_x and β_z, as chosen, by factors, for the paper's tracker and the belief tracker.

    The two poses that the former is given count for none of them.

    Parameters
    ----------
    components : Components
    factors : sequence of float, default=(0.25, 0.5, 1, 2, 4)
        Factors of each of the two.
    """
    check_values("factors", POSITIVE, *factors)
    training = prepare_tracking(components)
    data = training.described.data
    pairs = list(product(factors, factors))
    rows: list[Row] = []
    series: dict[str, Array] = {}
    grids: dict[str, Array] = {}
    with stage("tracking"):
        makers = {"state_sensitive": _state_sensitive(training), "tracker": _belief(training)}
        for method, make in makers.items():
            tracks = parallel_map(
                partial(_tracks, training, make), pairs, description=method, prefer="threads"
            )
            errors = [float(training.errors(own).mean()) for own in tracks]
            grids[method] = np.reshape(errors, (len(factors), len(factors)))
            for (on_x, on_z), own, error in zip(pairs, tracks, errors, strict=True):
                row: Row = {"method": method, "beta_x_factor": on_x, "beta_z_factor": on_z}
                rows.append({**row, "error": error})
                if on_z == 1:
                    series[f"{method} {on_x:g}"] = data.space.distance(data.test[0].x, own[0])
    metrics = {
        method: {"error": float(grid.min()), "widest_error": float(grid.max())}
        for method, grid in grids.items()
    }
    unit = in_words(data.space.metrics[0])
    methods = {method: palette.METHODS[method] for method in grids}
    record = partial(
        record_study,
        series=series,
        title=unit,
        legend=f"{coloured(methods)}; the narrower the kernel of the pose, the darker",
        frames_per_second=training.described.frames_per_second,
        colours={
            f"{method} {on_x:g}": palette.graded(colour, k, len(factors))
            for method, colour in methods.items()
            for k, on_x in enumerate(sorted(factors))
        },
    )
    headline = training.validation_error("tracker")
    return Result(
        data.name,
        metrics,
        rows=[*training.selection.rows, *rows],
        figure=_figure(factors, grids, unit),
        recording=Recording(f"{unit}, with the best and with the worst widths", record),
        headline=headline,
    )


def _tracks(
    training: TrackerTraining, make: MakeEstimate, factors: tuple[float, float]
) -> list[Array]:
    """Track every test take."""
    return training.follow({"": make(*factors)})[""]


def _state_sensitive(training: TrackerTraining) -> MakeEstimate:
    chosen = training.state_sensitive.regressor_

    def make(on_x: float, on_z: float) -> Estimate:
        tracker = training.state_sensitive_with(
            pose_width=chosen.pose_width * on_x, descriptor_width=chosen.descriptor_width * on_z
        )
        return lambda z, start: tracker.track(z, start).x

    return make


def _belief(training: TrackerTraining) -> MakeEstimate:
    chosen = training.tracker
    keys = chosen.key_poses(training.described.train)

    def make(on_x: float, on_z: float) -> Estimate:
        tracker = clone(chosen).set_params(
            pose_width=chosen.pose_width / np.sqrt(on_x),  # standard deviations, not β
            descriptor_width=chosen.descriptor_width / np.sqrt(on_z),
        )
        tracker.use_fitted(keys)
        return lambda z, _: tracker.track(z).x

    return make


@styled
def _figure(factors: Sequence[float], grids: Mapping[str, Array], unit: str) -> Figure:
    figure = Figure(figsize=(10.5, 5.2), layout="constrained")
    ticks = [f"{factor:g}" for factor in factors]
    best = min(float(grid.min()) for grid in grids.values())
    panels = figure.subplots(1, len(grids), sharey=True, squeeze=False)[0]
    for axes, (method, grid) in zip(panels, grids.items(), strict=True):
        picture = axes.imshow(grid, cmap="magma_r", origin="lower", vmin=best, vmax=2 * best)
        for (i, j), value in np.ndenumerate(grid):
            colour = "white" if value > 1.5 * best else "black"
            weight = "bold" if value == grid.min() else "normal"
            axes.text(j, i, f"{value:.2f}", ha="center", va="center", color=colour, weight=weight)
        without_ink(axes)
        axes.set_xticks(range(len(ticks)), ticks)
        axes.set_yticks(range(len(ticks)), ticks)
        axes.set(xlabel=r"factor of $\beta_z$, of the descriptor", title=in_words(method))
    panels[0].set_ylabel(r"factor of $\beta_x$, of the pose")
    figure.colorbar(picture, ax=panels, label=unit, extend="max", shrink=0.8)
    headline(
        figure, "How exactly must the kernels' widths be tuned?",
        "1 is what validation chooses; larger factors make a kernel narrower. Bold: the best.",
    )  # fmt: skip
    return figure
